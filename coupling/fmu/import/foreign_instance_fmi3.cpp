#include <cmath>
#include <sstream>

#include "coupling/fmu/fmi3.hpp"
#include "coupling/fmu/import/errors.hpp"
#include "coupling/fmu/import/foreign_instance.hpp"
#include "coupling/fmu/import/messages.hpp"

namespace orbearing::fmu {
namespace {

extern "C" void log_fmi3(fmi3InstanceEnvironment messages, fmi3Status, fmi3String category, fmi3String text) {
  if (messages != nullptr) static_cast<Messages*>(messages)->add(category, text);
}

const char* status_name(fmi3Status status) {
  constexpr const char* names[] = {"OK", "Warning", "Discard", "Error", "Fatal"};
  return status >= fmi3OK && status <= fmi3Fatal ? names[status] : "a status that the standard has not";
}

#define ORBEARING_ALWAYS(F)                                                                       \
  F(GetVersion)                                                                                   \
  F(InstantiateCoSimulation)                                                                      \
  F(FreeInstance) F(EnterInitializationMode) F(ExitInitializationMode) F(Terminate) F(SetFloat64) \
      F(SetInt32) F(SetInt64) F(SetBoolean) F(SetString) F(GetFloat64) F(DoStep)
#define ORBEARING_FOR_STATES(F) F(GetFMUState) F(SetFMUState) F(FreeFMUState)
#define ORBEARING_FOR_BYTES(F) F(SerializedFMUStateSize) F(SerializeFMUState) F(DeserializeFMUState)

struct Functions {
#define ORBEARING_MEMBER(name) fmi3##name##TYPE* name = nullptr;
  ORBEARING_ALWAYS(ORBEARING_MEMBER)
  ORBEARING_FOR_STATES(ORBEARING_MEMBER)
  ORBEARING_FOR_BYTES(ORBEARING_MEMBER)
#undef ORBEARING_MEMBER

  Functions(const SharedLibrary& library, const ForeignDescription& description) {
#define ORBEARING_LOOK_UP(name) name = library.function<fmi3##name##TYPE>("fmi3" #name);
    ORBEARING_ALWAYS(ORBEARING_LOOK_UP)
    if (description.keeps_state) {
      ORBEARING_FOR_STATES(ORBEARING_LOOK_UP)
    }
    if (description.serialises_state) {
      ORBEARING_FOR_BYTES(ORBEARING_LOOK_UP)
    }
#undef ORBEARING_LOOK_UP
  }
};

class InstanceFmi3 final : public ForeignInstance {
 public:
  InstanceFmi3(const LoadedFmu& fmu, const std::string& name) : call_{*fmu.library, fmu.description} {
    const std::string version = call_.GetVersion();
    if (version.rfind("3.", 0) != 0) {
      throw ForeignFmuError("its library is of FMI version " + version + "; required is 3.0");
    }
    const std::string resources = (fmu.resources / "").string();  // the standard wants the last '/'
    instance_ = call_.InstantiateCoSimulation(name.c_str(), fmu.description.token.c_str(), resources.c_str(),
                                              fmi3False, fmi3False, fmi3False, fmi3False, nullptr, 0,
                                              &messages_, log_fmi3, nullptr);
    if (instance_ == nullptr) {
      throw ForeignFmuError("fmi3InstantiateCoSimulation gave no instance" + messages_.take());
    }
  }

  ~InstanceFmi3() override {
    if (fatal_) return;
    if (running_) call_.Terminate(instance_);
    call_.FreeInstance(instance_);
  }

  void set_start(const ForeignVariableInfo& variable, const StartValue& value) override {
    const fmi3ValueReference reference = variable.reference;
    if (const auto* text = std::get_if<std::string>(&value)) {
      const fmi3String characters = text->c_str();
      check(call_.SetString(instance_, &reference, 1, &characters, 1), "fmi3SetString");
      return;
    }
    const double number = std::get<double>(value);
    const auto integer = static_cast<fmi3Int64>(std::llround(number));
    if (variable.type == "Float64") {
      check(call_.SetFloat64(instance_, &reference, 1, &number, 1), "fmi3SetFloat64");
    } else if (variable.type == "Boolean") {
      const fmi3Boolean truth = integer != 0;
      check(call_.SetBoolean(instance_, &reference, 1, &truth, 1), "fmi3SetBoolean");
    } else if (variable.type == "Int32") {
      const auto narrow = static_cast<fmi3Int32>(integer);
      check(call_.SetInt32(instance_, &reference, 1, &narrow, 1), "fmi3SetInt32");
    } else {
      check(call_.SetInt64(instance_, &reference, 1, &integer, 1), "fmi3SetInt64");
    }
  }

  void enter_initialization(double time) override {
    check(call_.EnterInitializationMode(instance_, fmi3False, 0.0, time, fmi3False, 0.0),
          "fmi3EnterInitializationMode");
  }
  void exit_initialization() override {
    check(call_.ExitInitializationMode(instance_), "fmi3ExitInitializationMode");
    running_ = true;
  }

  void set(const References& references, const std::vector<double>& values) override {
    const std::size_t number = references.size();
    if (number == 0) return;
    check(call_.SetFloat64(instance_, references.data(), number, values.data(), number), "fmi3SetFloat64");
  }
  void get(const References& references, std::vector<double>& values) override {
    const std::size_t number = references.size();
    values.resize(number);
    if (number == 0) return;
    check(call_.GetFloat64(instance_, references.data(), number, values.data(), number), "fmi3GetFloat64");
  }
  void set_slopes(const References&, int, const std::vector<double>&) override {
    throw ForeignFmuError("FMI 3.0 has no derivatives of inputs");
  }
  void step(double begin, double length) override {
    fmi3Boolean event = fmi3False, terminate = fmi3False, early = fmi3False;
    double reached = begin + length;
    const fmi3Status status =
        call_.DoStep(instance_, begin, length, fmi3False, &event, &terminate, &early, &reached);
    std::ostringstream text;
    text << "fmi3DoStep from " << begin << " s over " << length << " s";
    check(status, text.str());
    if (terminate || early) {
      text << (terminate ? " asks for the end of the simulation" : " came back early") << " at " << reached;
      throw ForeignFmuError(text.str() + " s" + messages_.take());
    }
  }

  void* take_state() override {
    void* state = nullptr;
    check(call_.GetFMUState(instance_, &state), "fmi3GetFMUState");
    return state;
  }
  void set_state(void* state) override { check(call_.SetFMUState(instance_, state), "fmi3SetFMUState"); }
  void free_state(void* state) noexcept override {
    if (!fatal_) call_.FreeFMUState(instance_, &state);
  }
  std::vector<unsigned char> serialised(void* state) override {
    std::size_t size = 0;
    check(call_.SerializedFMUStateSize(instance_, state, &size), "fmi3SerializedFMUStateSize");
    std::vector<unsigned char> bytes(size);
    check(call_.SerializeFMUState(instance_, state, bytes.data(), size), "fmi3SerializeFMUState");
    return bytes;
  }
  void* deserialised(const std::vector<unsigned char>& bytes) override {
    void* state = nullptr;
    check(call_.DeserializeFMUState(instance_, bytes.data(), bytes.size(), &state),
          "fmi3DeserializeFMUState");
    return state;
  }

 private:
  void check(fmi3Status status, const std::string& call) {
    if (status == fmi3OK || status == fmi3Warning) return;
    fatal_ = fatal_ || status == fmi3Fatal;
    running_ = running_ && status == fmi3Discard;  // after an error it may only be freed
    throw ForeignFmuError(call + " ended with " + status_name(status) + messages_.take());
  }

  Functions call_;
  Messages messages_;
  fmi3Instance instance_ = nullptr;
  bool running_ = false;
  bool fatal_ = false;
};

}  // namespace

std::unique_ptr<ForeignInstance> instantiate_fmi3(const LoadedFmu& fmu, const std::string& name) {
  return std::make_unique<InstanceFmi3>(fmu, name);
}

}  // namespace orbearing::fmu

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "coupling/fmu/fmi2.hpp"
#include "coupling/fmu/import/errors.hpp"
#include "coupling/fmu/import/foreign_instance.hpp"
#include "coupling/fmu/import/messages.hpp"

namespace orbearing::fmu {
namespace {

extern "C" {
// `format` may hold a printf format, whose arguments follow.
void log_fmi2(fmi2ComponentEnvironment messages, fmi2String, fmi2Status, fmi2String category,
              fmi2String format, ...) {
  char text[2048] = "";
  va_list arguments;
  va_start(arguments, format);
  if (format != nullptr) std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (messages != nullptr) static_cast<Messages*>(messages)->add(category, text);
}
void* allocate_fmi2(std::size_t number, std::size_t size) {
  return std::calloc(number, size);
}
void free_fmi2(void* memory) {
  std::free(memory);
}
}

const char* status_name(fmi2Status status) {
  constexpr const char* names[] = {"OK", "Warning", "Discard", "Error", "Fatal", "Pending"};
  return status >= fmi2OK && status <= fmi2Pending ? names[status] : "a status that the standard has not";
}

#define ORBEARING_ALWAYS(F)                                                                              \
  F(GetTypesPlatform)                                                                                    \
  F(GetVersion)                                                                                          \
  F(Instantiate) F(FreeInstance) F(SetupExperiment) F(EnterInitializationMode) F(ExitInitializationMode) \
      F(Terminate) F(SetReal) F(SetInteger) F(SetBoolean) F(SetString) F(GetReal) F(DoStep) F(GetRealStatus)
#define ORBEARING_FOR_STATES(F) F(GetFMUstate) F(SetFMUstate) F(FreeFMUstate)
#define ORBEARING_FOR_BYTES(F) F(SerializedFMUstateSize) F(SerializeFMUstate) F(DeSerializeFMUstate)
#define ORBEARING_FOR_SLOPES(F) F(SetRealInputDerivatives)

struct Functions {
#define ORBEARING_MEMBER(name) fmi2##name##TYPE* name = nullptr;
  ORBEARING_ALWAYS(ORBEARING_MEMBER)
  ORBEARING_FOR_STATES(ORBEARING_MEMBER)
  ORBEARING_FOR_BYTES(ORBEARING_MEMBER)
  ORBEARING_FOR_SLOPES(ORBEARING_MEMBER)
#undef ORBEARING_MEMBER

  Functions(const SharedLibrary& library, const ForeignDescription& description) {
#define ORBEARING_LOOK_UP(name) name = library.function<fmi2##name##TYPE>("fmi2" #name);
    ORBEARING_ALWAYS(ORBEARING_LOOK_UP)
    if (description.keeps_state) {
      ORBEARING_FOR_STATES(ORBEARING_LOOK_UP)
    }
    if (description.serialises_state) {
      ORBEARING_FOR_BYTES(ORBEARING_LOOK_UP)
    }
    if (description.interpolates_inputs) {
      ORBEARING_FOR_SLOPES(ORBEARING_LOOK_UP)
    }
#undef ORBEARING_LOOK_UP
  }
};

class InstanceFmi2 final : public ForeignInstance {
 public:
  InstanceFmi2(const LoadedFmu& fmu, const std::string& name) : call_{*fmu.library, fmu.description} {
    check_version();
    component_ = call_.Instantiate(name.c_str(), fmi2CoSimulation, fmu.description.token.c_str(),
                                   file_uri(fmu.resources).c_str(), &callbacks_, fmi2False, fmi2False);
    if (component_ == nullptr) throw ForeignFmuError("fmi2Instantiate gave no instance" + messages_.take());
  }

  ~InstanceFmi2() override {
    if (fatal_) return;
    if (running_) call_.Terminate(component_);
    call_.FreeInstance(component_);
  }

  void set_start(const ForeignVariableInfo& variable, const StartValue& value) override {
    const unsigned reference = variable.reference;
    if (const auto* text = std::get_if<std::string>(&value)) {
      const fmi2String characters = text->c_str();
      check(call_.SetString(component_, &reference, 1, &characters), "fmi2SetString");
      return;
    }
    const double number = std::get<double>(value);
    const int integer = static_cast<int>(std::lround(number));
    if (variable.type == "Real") {
      check(call_.SetReal(component_, &reference, 1, &number), "fmi2SetReal");
    } else if (variable.type == "Boolean") {
      check(call_.SetBoolean(component_, &reference, 1, &integer), "fmi2SetBoolean");
    } else {
      check(call_.SetInteger(component_, &reference, 1, &integer), "fmi2SetInteger");
    }
  }

  void enter_initialization(double time) override {
    check(call_.SetupExperiment(component_, fmi2False, 0.0, time, fmi2False, 0.0), "fmi2SetupExperiment");
    check(call_.EnterInitializationMode(component_), "fmi2EnterInitializationMode");
  }
  void exit_initialization() override {
    check(call_.ExitInitializationMode(component_), "fmi2ExitInitializationMode");
    running_ = true;
  }

  void set(const References& references, const std::vector<double>& values) override {
    if (references.empty()) return;
    check(call_.SetReal(component_, references.data(), references.size(), values.data()), "fmi2SetReal");
  }
  void get(const References& references, std::vector<double>& values) override {
    values.resize(references.size());
    if (references.empty()) return;
    check(call_.GetReal(component_, references.data(), references.size(), values.data()), "fmi2GetReal");
  }
  void set_slopes(const References& references, int order, const std::vector<double>& values) override {
    if (references.empty()) return;
    const std::vector<fmi2Integer> orders(references.size(), order);
    check(call_.SetRealInputDerivatives(component_, references.data(), references.size(), orders.data(),
                                        values.data()),
          "fmi2SetRealInputDerivatives of order " + std::to_string(order));
  }
  void step(double begin, double length) override {
    const fmi2Status status = call_.DoStep(component_, begin, length, fmi2False);
    if (status == fmi2OK) return;
    std::ostringstream text;
    text << "fmi2DoStep from " << begin << " s over " << length << " s";
    double reached = 0.0;
    if (status == fmi2Discard &&
        call_.GetRealStatus(component_, fmi2LastSuccessfulTime, &reached) == fmi2OK) {
      text << " (it came to " << reached << " s)";
    }
    check(status, text.str());
  }

  void* take_state() override {
    void* state = nullptr;
    check(call_.GetFMUstate(component_, &state), "fmi2GetFMUstate");
    return state;
  }
  void set_state(void* state) override { check(call_.SetFMUstate(component_, state), "fmi2SetFMUstate"); }
  void free_state(void* state) noexcept override {
    if (!fatal_) call_.FreeFMUstate(component_, &state);
  }
  std::vector<unsigned char> serialised(void* state) override {
    std::size_t size = 0;
    check(call_.SerializedFMUstateSize(component_, state, &size), "fmi2SerializedFMUstateSize");
    std::vector<unsigned char> bytes(size);
    check(call_.SerializeFMUstate(component_, state, reinterpret_cast<fmi2Byte*>(bytes.data()), size),
          "fmi2SerializeFMUstate");
    return bytes;
  }
  void* deserialised(const std::vector<unsigned char>& bytes) override {
    void* state = nullptr;
    check(call_.DeSerializeFMUstate(component_, reinterpret_cast<const fmi2Byte*>(bytes.data()), bytes.size(),
                                    &state),
          "fmi2DeSerializeFMUstate");
    return state;
  }

 private:
  void check_version() const {
    const std::string version = call_.GetVersion(), platform = call_.GetTypesPlatform();
    if (version.rfind("2.", 0) != 0 || platform != "default") {
      throw ForeignFmuError("its library is of FMI version " + version + " and types platform '" + platform +
                            "'; required are 2.0 and 'default'");
    }
  }
  void check(fmi2Status status, const std::string& call) {
    if (status == fmi2OK || status == fmi2Warning) return;
    fatal_ = fatal_ || status == fmi2Fatal;
    running_ = running_ && status == fmi2Discard;  // after an error it may only be freed
    throw ForeignFmuError(call + " ended with " + status_name(status) + messages_.take());
  }

  Functions call_;
  Messages messages_;
  fmi2CallbackFunctions callbacks_{log_fmi2, allocate_fmi2, free_fmi2, nullptr, &messages_};
  fmi2Component component_ = nullptr;
  bool running_ = false;
  bool fatal_ = false;
};

}  // namespace

std::unique_ptr<ForeignInstance> instantiate_fmi2(const LoadedFmu& fmu, const std::string& name) {
  return std::make_unique<InstanceFmi2>(fmu, name);
}

std::string file_uri(const std::filesystem::path& path) {
  constexpr const char* digits = "0123456789ABCDEF";
  const std::string plain =
      "/-._~ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";  // RFC 3986
  std::string uri = "file://";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string::npos) {
      uri += c;
    } else {
      (((uri += '%') += digits[byte >> 4]) += digits[byte & 15]);
    }
  }
  return uri;
}

}  // namespace orbearing::fmu

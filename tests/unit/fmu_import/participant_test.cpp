#include "coupling/fmu/import/foreign_participant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/fmu/import/errors.hpp"
#include "tests/foreign/archive.hpp"

namespace orbearing::fmu::participant_test {
namespace {

using namespace orbearing::cosim;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double round_off = 1e-12;  // of sums of some thousand numbers of size 1

ForeignPort body_port() {
  return {{"body", PortKind::translation, Gives::motion}, {"displacement"}, {"velocity"}, {"force"}};
}
ForeignPort spring_port() {
  return {{"spring", PortKind::translation, Gives::force},
          {"spring.displacement"},
          {"spring.velocity"},
          {"spring.force"}};
}

std::vector<PortInput> force(const Course& course) {
  return {{.force = course}};
}

struct OneBody {
  explicit OneBody(tests::SpringMassOptions options, ForeignSetup setup = {}) {
    setup.file = tests::spring_mass_fmu(folder, options);
    if (setup.ports.empty()) setup.ports = {body_port()};
    participant = import_fmu(setup);
  }
  PortOutput output() const {
    std::vector<PortOutput> outputs;
    participant->output(outputs);
    return outputs.at(0);
  }
  // Under the force rate x time, from 0 to the end of window number `windows`.
  void run(int windows, double length, double rate) {
    for (int k = 0; k < windows; ++k) {
      const Window window{k * length, (k + 1) * length};
      participant->set_input(force({{rate * window.begin, rate, 0.0, 0.0}}));
      participant->advance(window);
    }
  }

  tests::Folder folder;
  std::unique_ptr<Participant> participant;
};

class ForeignParticipants : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Versions, ForeignParticipants, testing::Values(2, 3));

// A free body under a constant force: x = F t^2 / 2 m, v = F t / m.
TEST_P(ForeignParticipants, MoveAsTheirModelSays) {
  OneBody body{{.version = GetParam()}, {.values = {{"mass", 4.0}}}};
  EXPECT_EQ(body.participant->name(), "spring mass");
  EXPECT_EQ(body.participant->ports().at(0).name, "body");
  body.participant->initialize(0.0, force(Course::constant(2.0)));
  for (int k = 0; k < 10; ++k) {
    body.participant->set_input(force(Course::constant(2.0)));
    body.participant->advance({k * 0.01, (k + 1) * 0.01});
  }
  EXPECT_NEAR(body.output().displacement, 2.0 * 0.1 * 0.1 / (2.0 * 4.0), round_off);
  EXPECT_NEAR(body.output().velocity, 2.0 * 0.1 / 4.0, round_off);
}

// Under F = a t: x = a t^3 / 6 m. A force held at its mean over steps of h gives a h^2 t / 12 m too much,
// one held at the beginning a h t^2 / 4 m too little to the leading order; an FMU that gets the slope misses
// nothing.
TEST_P(ForeignParticipants, HoldInputsAsTheyAreTold) {
  const double rate = 3.0, end = 0.1, exact = rate * end * end * end / 6.0;
  const auto error = [&](Held held, int steps_per_window, bool interpolates) {
    ForeignPort port = body_port();
    port.force.held = held;
    ForeignSetup setup{.ports = {port}};
    setup.steps_per_window = steps_per_window;
    OneBody body{{.version = GetParam(), .interpolates = interpolates}, setup};
    body.participant->initialize(0.0, force({}));
    body.run(10, 0.01, rate);
    return body.output().displacement - exact;
  };
  EXPECT_NEAR(error(Held::mean, 1, false), rate * 1e-4 * end / 12.0, round_off);
  EXPECT_NEAR(error(Held::mean, 4, false), rate * 1e-4 / 16.0 * end / 12.0, round_off);
  EXPECT_NEAR(error(Held::at_begin, 1, false), -rate * 0.01 * end * end / 4.0, rate * 1e-4 * end / 4.0);
  if (GetParam() == 2) {
    EXPECT_NEAR(error(Held::at_begin, 1, true), 0.0, round_off);
  }
}

// A spring that others move answers with the force of the end of the window.
TEST_P(ForeignParticipants, GiveForcesWithoutDelay) {
  OneBody spring{
      {.version = GetParam(), .interpolates = false},
      {.ports = {spring_port()}, .values = {{"spring.stiffness", 100.0}, {"spring.damping", 2.0}}}};
  const Course way{{0.1, 0.5, 0.25, 0.0}}, slope{{0.5, 0.5, 0.0, 0.0}};
  spring.participant->initialize(0.0, {{.displacement = Course::constant(0.1)}});
  EXPECT_NEAR(spring.output().force, -100.0 * 0.1, round_off);
  spring.participant->set_input({{.displacement = way, .velocity = slope}});
  spring.participant->advance({0.0, 0.2});
  EXPECT_NEAR(spring.output().force, -100.0 * way.at(0.2) - 2.0 * slope.at(0.2), round_off);
}

// What is set after a step, before the next one: answered at once where the FMU does that.
TEST_P(ForeignParticipants, AnswerBetweenStepsWhereTheyCan) {
  for (const bool answers : {false, true}) {
    ForeignSetup setup{.ports = {spring_port()}, .values = {{"spring.stiffness", 100.0}}};
    setup.answers_between_steps = answers;
    OneBody spring{{.version = GetParam()}, setup};
    spring.participant->initialize(0.0, {{.displacement = Course::constant(0.1)}});
    spring.participant->set_input({{.displacement = {{0.2, 1.0, 0.0, 0.0}}}});
    EXPECT_NEAR(spring.output().force, answers ? -20.0 : -10.0, round_off);
  }
}

TEST_P(ForeignParticipants, ComeBackToTheSameBits) {
  const ForeignSetup oscillator{.ports = {}, .values = {{"stiffness", 1e4}, {"damping", 3.0}}};
  OneBody body{{.version = GetParam()}, oscillator}, other{{.version = GetParam()}, oscillator};
  body.participant->initialize(0.0, force(Course::constant(1.0)));
  body.run(3, 0.01, 7.0);
  SavedState state;
  body.participant->save(state);
  const auto advanced = [&](OneBody& which) {
    which.participant->set_input(force({{1.0, -3.0, 0.0, 0.0}}));
    which.participant->advance({0.03, 0.04});
    return which.output();
  };
  const PortOutput first = advanced(body);
  body.participant->restore(state);
  const PortOutput again = advanced(body);
  other.participant->initialize(0.0, force({}));
  other.participant->restore(state);
  const PortOutput elsewhere = advanced(other);
  EXPECT_NE(first.displacement, 0.0);
  EXPECT_EQ(first.displacement, again.displacement);
  EXPECT_EQ(first.velocity, again.velocity);
  EXPECT_EQ(first.displacement, elsewhere.displacement);
  EXPECT_EQ(first.velocity, elsewhere.velocity);
  state.back() = 0.5;
  EXPECT_THROW(body.participant->restore(state), ForeignFmuError);
}

TEST_P(ForeignParticipants, KeepTheLastStatesWhereTheyCannotSerialise) {
  OneBody body{{.version = GetParam(), .serialises = false}};
  body.participant->initialize(0.0, force({}));
  std::vector<SavedState> states(9);
  for (int k = 0; k < 9; ++k) {
    body.participant->save(states[static_cast<std::size_t>(k)]);
    body.participant->set_input(force(Course::constant(1.0)));
    body.participant->advance({k * 0.1, (k + 1) * 0.1});
  }
  EXPECT_THAT([&] { body.participant->restore(states[0]); },
              ThrowsMessage<ForeignFmuError>(HasSubstr("a saved state that is gone")));
  body.participant->restore(states[1]);
  EXPECT_NEAR(body.output().velocity, 0.1, round_off);
}

TEST_P(ForeignParticipants, SayThatTheyCannotSave) {
  OneBody body{{.version = GetParam(), .keeps_state = false}};
  body.participant->initialize(0.0, force({}));
  SavedState state;
  EXPECT_THAT([&] { body.participant->save(state); },
              ThrowsMessage<ForeignFmuError>(
                  AllOf(HasSubstr(".fmu: cannot save its state"), HasSubstr("canGetAndSetFMUstate"))));
}

// A step that is discarded halfway leaves the body where it was, and shorter ones go on from there.
TEST_P(ForeignParticipants, StandAtTheBeginningAfterAnError) {
  OneBody body{{.version = GetParam()}, {.values = {{"fault", 1.0}, {"longest_step", 0.01}}}};
  body.participant->initialize(0.0, force({}));
  body.run(2, 0.01, 3.0);
  const PortOutput before = body.output();
  EXPECT_THAT(
      [&] {
        body.participant->advance({0.02, 0.04});
      },
      ThrowsMessage<ForeignFmuError>(AllOf(HasSubstr("DoStep from 0.02 s over 0.02 s"),
                                           HasSubstr("ended with Discard"),
                                           HasSubstr("it says: [logStatus] the step is too long"))));
  EXPECT_EQ(body.output().displacement, before.displacement);
  EXPECT_EQ(body.output().velocity, before.velocity);
  body.participant->set_input(force({{0.06, 3.0, 0.0, 0.0}}));
  body.participant->advance({0.02, 0.03});
  EXPECT_NEAR(body.output().velocity, 3.0 * 0.03 * 0.03 / 2.0, round_off);
}

TEST_P(ForeignParticipants, WithoutStatesCannotGoOnAfterAnError) {
  OneBody body{{.version = GetParam(), .keeps_state = false},
               {.values = {{"fault", 1.0}, {"longest_step", 0.01}}}};
  body.participant->initialize(0.0, force({}));
  EXPECT_THROW(body.participant->advance({0.0, 0.1}), ForeignFmuError);
  EXPECT_THAT(
      [&] {
        body.participant->advance({0.0, 0.01});
      },
      ThrowsMessage<ForeignFmuError>(HasSubstr("cannot go on after an error")));
  body.participant->initialize(0.0, force({}));
  body.run(1, 0.01, 3.0);
  EXPECT_NEAR(body.output().velocity, 3.0 * 0.01 * 0.01 / 2.0, round_off);
}

// The model aborts where it is terminated after an error or called at all after a fatal one.
TEST_P(ForeignParticipants, AreLeftAloneAfterErrorsAsTheStandardWants) {
  for (const double fault : {2.0, 3.0}) {
    OneBody body{{.version = GetParam(), .keeps_state = false}, {.values = {{"fault", fault}}}};
    body.participant->initialize(0.0, force({}));
    EXPECT_THAT(
        [&] {
          body.participant->advance({0.0, 0.1});
        },
        ThrowsMessage<ForeignFmuError>(HasSubstr("the spring broke")));
    EXPECT_THROW(body.output(), ForeignFmuError);
  }
}

TEST_P(ForeignParticipants, LetNoNumberPassThatIsNone) {
  OneBody body{{.version = GetParam()}, {.values = {{"fault", 4.0}}}};
  EXPECT_THROW(body.participant->initialize(0.0, force(Course::constant(std::nan("")))), ForeignFmuError);
  body.participant->initialize(0.0, force({}));
  EXPECT_THAT([&] { body.output(); },
              ThrowsMessage<ForeignFmuError>(HasSubstr("a value that is not finite at port body")));
}

TEST_P(ForeignParticipants, SayWhyTheyDoNotBegin) {
  EXPECT_THAT(
      [&] { OneBody({.version = GetParam(), .token = "other"}).participant->initialize(0.0, force({})); },
      ThrowsMessage<ForeignFmuError>(HasSubstr("gave no instance; it says: [logStatus] wrong token other")));
  OneBody strict{{.version = GetParam()},
                 {.values = {{"strict", 1.0}, {"label", std::string("too strict")}}}};
  EXPECT_THAT([&] { strict.participant->initialize(0.0, force({})); },
              ThrowsMessage<ForeignFmuError>(
                  AllOf(HasSubstr("ExitInitializationMode ended with Error"), HasSubstr("too strict"))));
  EXPECT_THROW(strict.participant->advance({0.0, 0.1}), ForeignFmuError);
}

TEST_P(ForeignParticipants, RefuseWindowsThatTheyCannotTake) {
  OneBody body{{.version = GetParam(), .variable_step = false}};
  EXPECT_THROW(body.participant->advance({0.0, 0.1}), ForeignFmuError) << "before initialize";
  body.participant->initialize(0.0, force({}));
  body.run(2, 0.1, 1.0);
  for (const Window& window : {Window{0.3, 0.4}, Window{0.2, 0.2}, Window{0.2, 0.1}, Window{0.2, HUGE_VAL}}) {
    EXPECT_THAT([&] { body.participant->advance(window); },
                ThrowsMessage<ForeignFmuError>(HasSubstr("required is one from 0.2 s")));
  }
  EXPECT_THAT(
      [&] {
        body.participant->advance({0.2, 0.4});
      },
      ThrowsMessage<ForeignFmuError>(HasSubstr("steps of 0.1 s only")));
  EXPECT_THROW(body.participant->set_input({}), ForeignFmuError);
}

TEST(ForeignParticipants2, NeedALibraryForThisMachine) {
  const tests::Folder folder;
  const auto file = folder.path / "a.fmu";
  const auto message = [&](const tests::Entries& entries) {
    tests::write_archive(file, entries);
    try {
      import_fmu({.file = file, .ports = {body_port()}});
    } catch (const ForeignFmuError& error) {
      return std::string(error.what());
    }
    return std::string("imported");
  };
  const std::string xml = tests::spring_mass_description();
  EXPECT_THAT(message({{"modelDescription.xml", xml}}),
              HasSubstr("a.fmu: holds no binaries/linux64/spring_mass.so, the library for this machine"));
  EXPECT_THAT(message({{"modelDescription.xml", xml}, {"binaries/linux64/spring_mass.so", "no library"}}),
              HasSubstr("library cannot be loaded"));
}

}  // namespace
}  // namespace orbearing::fmu::participant_test

#include "benchmarks/cvode.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace orbearing::bench {

namespace {

constexpr long kMostStepsBetweenSamples = 100'000'000;

template <auto release>
struct Release {
  template <class Handle>
  void operator()(Handle* handle) const {
    release(handle);
  }
};
template <class Handle, auto release>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>>;

void free_context(SUNContext context) {
  SUNContext_Free(&context);
}
void free_cvode(void* memory) {
  CVodeFree(&memory);
}
struct FreeCvode {
  void operator()(void* memory) const { free_cvode(memory); }
};

using Context = Owned<SUNContext, free_context>;
using Vector = Owned<N_Vector, N_VDestroy>;
using Matrix = Owned<SUNMatrix, SUNMatDestroy>;
using Solver = Owned<SUNLinearSolver, SUNLinSolFree>;
using Memory = std::unique_ptr<void, FreeCvode>;

int call_derivative(realtype time, N_Vector x, N_Vector dx, void* derivative) {
  (*static_cast<const FlatDerivative*>(derivative))(time, N_VGetArrayPointer(x), N_VGetArrayPointer(dx));
  return 0;
}

// CVODE reports errors by negative numbers, and also on standard error.
void require(int flag, const char* what) {
  if (flag < 0)
    throw std::runtime_error(std::string("CVODE: ") + what + " ended with code " + std::to_string(flag));
}

Context make_context() {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context), "creation");
  return Context(context);
}

CvodeReport report_of(void* memory) {
  CvodeReport report;
  long jacobian_calls = 0;
  CVodeGetNumSteps(memory, &report.steps);
  CVodeGetNumRhsEvals(memory, &report.rhs_calls);
  CVodeGetNumJacEvals(memory, &report.jacobians);
  CVodeGetNumLinRhsEvals(memory, &jacobian_calls);
  CVodeGetCurrentTime(memory, &report.end_time);
  report.rhs_calls += jacobian_calls;
  return report;
}

}  // namespace

CvodeReport run_cvode(const FlatDerivative& derivative, Eigen::VectorXd& x, double duration, long samples,
                      const Eigen::VectorXd& allowed, int most_order, const FlatObserver& observe) {
  const Context context = make_context();
  const sunindextype n = x.size();
  Eigen::VectorXd allowed_copy = allowed;
  const Vector state(N_VMake_Serial(n, x.data(), context.get()));
  const Vector tolerance(N_VMake_Serial(n, allowed_copy.data(), context.get()));
  const Matrix jacobian(SUNDenseMatrix(n, n, context.get()));
  const Solver solver(SUNLinSol_Dense(state.get(), jacobian.get(), context.get()));
  const Memory memory(CVodeCreate(CV_BDF, context.get()));
  require(CVodeInit(memory.get(), call_derivative, 0.0, state.get()), "initialisation");
  require(CVodeSVtolerances(memory.get(), 0.0, tolerance.get()), "setting tolerances");
  require(CVodeSetUserData(memory.get(), const_cast<FlatDerivative*>(&derivative)), "setting the equations");
  require(CVodeSetLinearSolver(memory.get(), solver.get(), jacobian.get()), "setting the linear solver");
  require(CVodeSetMaxNumSteps(memory.get(), kMostStepsBetweenSamples), "setting the number of steps");
  require(CVodeSetMaxOrd(memory.get(), most_order), "setting the order");
  for (long i = 1; i <= samples; ++i) {
    const double until = duration * static_cast<double>(i) / static_cast<double>(samples);
    double time = 0.0;
    require(CVode(memory.get(), until, state.get(), &time, CV_NORMAL), "integration");
    if (observe) observe(time, x.data());
  }
  return report_of(memory.get());
}

}  // namespace orbearing::bench

#include <cstdio>
#include <cstdlib>
#include <string>
#include "benchmarks/runs.hpp"
using namespace orbearing::bench;
int main(int argc, char** argv) {
  const double rpm = std::atof(argv[1]), clr = std::atof(argv[2]);
  const int revs = argc > 3 ? std::atoi(argv[3]) : 10;
  Contest c(duty_at(shipped_reducer(), rpm, clr));
  const double rev = c.duty().cage_revolution();
  const Eigen::VectorXd start = c.settled(3 * rev);
  const Span span{revs * rev, 20000L * revs};
  auto show = [&](const char* n, Method m, double tol) {
    try {
      const Run r = c.run(m, start, span, tol);
      std::printf("%-12s %8.2g  rms %.5f %.5f max %.4f cage %.5f  steps %ld  %.1f us/step RTF %.3f\n", n, tol, r.means.inner_rms,
                  r.means.outer_rms, r.means.load_max, r.means.cage_speed, r.steps, 1e6*span.duration/static_cast<double>(r.steps), span.duration / r.cpu_seconds);
    } catch (std::exception& e) { std::printf("%s %g: %s\n", n, tol, e.what()); }
    std::fflush(stdout);
  };
  const std::string which = argc > 4 ? argv[4] : "rfdc";
  if (which.find('r') != std::string::npos) { show("rk4", Method::rk4, 2e-7); show("rk4", Method::rk4, 1.8e-7);}
  if (which.find('f') != std::string::npos) for (double t : {3e-8, 1e-8, 3e-9, 1e-9, 3e-10}) show("fast", Method::fast, t);
  if (which.find('d') != std::string::npos) for (double t : {1e-7, 1e-8, 1e-9, 1e-10}) show("fast_dopri5", Method::fast_dopri5, t);
  if (which.find('p') != std::string::npos) for (double t : {1e-8}) show("plain_dopri5", Method::plain_dopri5, t);
  if (which.find('c') != std::string::npos) for (double t : {1e-7, 1e-8, 1e-9}) show("cvode", Method::cvode, t);
}

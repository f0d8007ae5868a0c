#include "app/commands/command_line.hpp"
#include "app/standard_error.hpp"

int main(int argc, char** argv) {
  orbearing::app::hold_standard_streams();
  return orbearing::app::run_command_line(argc, argv);
}

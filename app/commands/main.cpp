#include "app/commands/command_line.hpp"

int main(int argc, char** argv) {
  return orbearing::app::run_command_line(argc, argv);
}

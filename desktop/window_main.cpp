#include "desktop/cli/cli.hpp"

int main(int argc, char** argv) { return snug::desktop::run_command(argc, argv, &snug::desktop::run_window); }

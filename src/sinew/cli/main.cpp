#include <sinew/cli/command_line.hpp>

int main(int count, char** arguments) { return sinew::command_line(count, arguments); }

#include "ideotype/app/verbs.hpp"

int main(int argc, char** argv) {
    return ideotype::run_command_line(argc, argv);
}

#include "cli.h"

int main(int argc, char** argv) { return dbd::RunProgram(argc, argv); }

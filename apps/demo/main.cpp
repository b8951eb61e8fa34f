#include "apps/demo/program.h"

int main(int argc, char** argv) {
    return scanlight::demo::run(argc, argv);
}

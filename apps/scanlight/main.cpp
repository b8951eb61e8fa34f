#include "apps/scanlight/program.h"

int main(int argc, char** argv) {
    return scanlight::apps::run(argc, argv);
}

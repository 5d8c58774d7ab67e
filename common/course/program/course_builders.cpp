// Answers the questions of a job by the builders as they stand (./course runs it).
#include "course/answer_builders.h"

int main(int argc, char** argv) {
    return raysteps::answer_job(argc, argv, raysteps::answer_by_builders);
}

// Answers the questions of a job by the builders and other functions in C++ as they stand (./course
// runs it).
#include "answer_builders.h"
#include "answer_functions.h"

using namespace raysteps;

int main(int argc, char** argv) {
    return answer_job(argc, argv, [](const CourseQuestion& question) {
        return question.kind == QuestionKind::function ? answer_by_functions(question)
                                                       : answer_by_builders(question);
    });
}

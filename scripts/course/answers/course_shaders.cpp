// Answers the questions of a job by the shader parts as they stand; without arguments, one job
// after another in one context (./course runs it).
#include "answer_shaders.h"
#include "gpu/context.h"

using namespace raysteps;

int main(int argc, char** argv) {
    std::unique_ptr<Context> context;
    KeptProgram kept;
    const auto answer = [&](const CourseQuestion& question) {
        if (!context && question.kind != QuestionKind::difference) {
            context = make_context(ContextKind::osmesa);
        }
        return answer_by_shaders(question, kept);
    };
    if (argc == 1) {
        answer_jobs(answer);
        return 0;
    }
    return answer_job(argc, argv, answer);
}

// Answers the questions of a job by the shader parts as they stand (./course runs it).
#include "answer_shaders.h"
#include "gpu/context.h"

using namespace raysteps;

int main(int argc, char** argv) {
    std::unique_ptr<Context> context;
    return answer_job(argc, argv, [&](const Question& question) {
        if (!context && question.kind != QuestionKind::difference) {
            context = make_context(ContextKind::osmesa);
        }
        return answer_by_shaders(question);
    });
}

#pragma once

#include <functional>
#include <string>

namespace raysteps {

// A line that shows how far a long work is, with the time that is left. Only on a terminal: in a
// pipe it is quiet.
std::function<void(double part_done)> show_progress(const std::string& work);

// A line that says what is being done, for as long as this lives; on a terminal only. For work that
// does not know how far it is.
class WorkNotice {
public:
    explicit WorkNotice(const std::string& work);
    ~WorkNotice();
    WorkNotice(const WorkNotice&) = delete;
    WorkNotice& operator=(const WorkNotice&) = delete;
};

} // namespace raysteps

#include "basics/file.h"

#include "support/error_of.h"
#include "support/scratch_folder.h"

#include "catch.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

using namespace raysteps;

namespace {

// While it lives, no file can grow over that many bytes: it stands for a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t most_bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_limit_);
        const rlimit limit{most_bytes, old_limit_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit old_limit_{};
    void (*old_handler_)(int);
};

} // namespace

TEST_CASE("a file is written with the folders that lack and replaces the old one", "[file]") {
    const ScratchFolder folder("write");
    write_file(folder / "new/deep/file.txt", "one");
    CHECK(bytes_of(folder / "new/deep/file.txt") == "one");
    write_file(folder / "new/deep/file.txt", "two");
    CHECK(bytes_of(folder / "new/deep/file.txt") == "two");
}

TEST_CASE("a file's name may be as long as the system allows", "[file]") {
    const ScratchFolder folder("write_long_name");
    const std::string name(255, 'x');
    write_file(folder / name, "one");
    CHECK(bytes_of(folder / name) == "one");
    CHECK(!error_of([&] { write_file(folder / (name + "x"), "one"); }).empty());
}

TEST_CASE("a write that fails leaves the old file and nothing else", "[file]") {
    const ScratchFolder folder("write_full_disk");
    put_bytes(folder / "file.txt", "old");
    // The smaller one fits into the buffer of the C library, and fails only as the file is closed.
    for (const std::size_t size : {2'000, 100'000}) {
        CAPTURE(size);
        std::string error;
        {
            const FullDisk full_disk(1'000);
            error = error_of([&] { write_file(folder / "file.txt", std::string(size, 'x')); });
        }
        CHECK(error.find("file.txt: cannot be written: ") != std::string::npos);
    }
    CHECK(bytes_of(folder / "file.txt") == "old");
    CHECK(folder.file_count() == 1);
}

TEST_CASE("a path that cannot be a file is an error with the reason", "[file]") {
    const ScratchFolder folder("write_paths");
    put_bytes(folder / "file.txt", "old");
    std::filesystem::create_directory(folder / "inside");
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0); // stands for /dev/null
    const auto error = [](const std::filesystem::path& path) {
        return error_of([&] { write_file(path, "new"); });
    };
    CHECK(error(folder / "file.txt/inner.txt").find("folder cannot be made") != std::string::npos);
    CHECK(error(folder / "inside").find("it is a folder or a device") != std::string::npos);
    CHECK(error(folder / "inside/").find("it names no file") != std::string::npos);
    CHECK(error("").find("it names no file") != std::string::npos);
    CHECK(error(folder / "pipe").find("it is a folder or a device") != std::string::npos);
    CHECK(bytes_of(folder / "file.txt") == "old");
    CHECK(folder.file_count() == 3);
}

TEST_CASE("a file over the limit is not read", "[file]") {
    const ScratchFolder folder("read_limit");
    put_bytes(folder / "file.txt", "four");
    CHECK(read_file(folder / "file.txt", 4) == "four");
    CHECK(error_of([&] { read_file(folder / "file.txt", 3); }).find("the limit is 3") !=
          std::string::npos);
    CHECK(error_of([] { read_file("/dev/zero", 3); }).find("device") != std::string::npos);
}

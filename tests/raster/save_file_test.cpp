#include "raster/save_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <span>

#include "raster/image_error.h"
#include "tests/raster/temporary_folder.h"

namespace {

// Goes wrong once, at the `countdown`-th of these system calls that this program makes.
enum class Call { none, write, fsync, rename };
constexpr int short_write = 0;
constexpr int killed = -1;
struct Fault {
    Call call = Call::none;
    int countdown = 0;
    int error = 0;  // of errno, or one of the two above
};
Fault fault;

bool strikes(Call call) {
    if (fault.call != call || --fault.countdown != 0) return false;
    fault.call = Call::none;
    errno = fault.error;
    return true;
}

int fail() {
    if (fault.error == killed) raise(SIGKILL);
    return -1;
}

ssize_t write_half(int fd, const void* bytes, size_t count) {
    return syscall(SYS_write, fd, bytes, count / 2 + count % 2);
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* bytes, size_t count) {
    if (strikes(Call::write)) {
        if (fault.error > 0) return -1;
        const ssize_t half = write_half(fd, bytes, count);
        return fault.error == short_write ? half : fail();
    }
    return syscall(SYS_write, fd, bytes, count);
}

int fsync(int fd) {
    if (strikes(Call::fsync)) return fail();
    return static_cast<int>(syscall(SYS_fsync, fd));
}

int rename(const char* from, const char* to) noexcept {
    if (strikes(Call::rename)) return fail();
    return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

}  // extern "C"

namespace scanlight::raster {
namespace {

std::string complaint(const std::string& path, std::string_view text) {
    try {
        save_file(path, text);
        return {};
    } catch (const ImageError& error) {
        return error.what();
    }
}

mode_t mode_of(const std::string& path) {
    struct stat status;
    EXPECT_EQ(stat(path.c_str(), &status), 0);
    return status.st_mode & 0777;
}

class SaveFile : public testing::Test {
protected:
    ~SaveFile() override { fault = {}; }

    void expect_only(const std::string& text) {
        EXPECT_EQ(contents_of(path), text);
        EXPECT_EQ(folder.file_count(), 1u);
    }

    const TemporaryFolder folder;
    const std::string path = folder / "out.png";
};

TEST_F(SaveFile, MakesAndReplacesAFile) {
    save_file(path, "first");
    expect_only("first");
    save_file(path, "2nd");
    expect_only("2nd");
    save_file(path, "");
    expect_only("");
}

TEST_F(SaveFile, TakesAPathWithoutAFolder) {
    const auto here = std::filesystem::current_path();
    std::filesystem::current_path(std::filesystem::path(path).parent_path());
    save_file("out.png", "here");
    std::filesystem::current_path(here);
    expect_only("here");
}

TEST_F(SaveFile, LeavesTheOldFileWhenAnyCallFails) {
    for (const Call call : {Call::write, Call::fsync, Call::rename}) {
        for (const int error : {ENOSPC, EIO, EDQUOT}) {
            put(path, "old");
            fault = {call, 1, error};
            EXPECT_EQ(complaint(path, "new"),
                      path + ": cannot be written: " + std::strerror(error));
            expect_only("old");
        }
    }
}

TEST_F(SaveFile, LeavesNothingWhenAnyCallFailsOnANewFile) {
    for (const Call call : {Call::write, Call::fsync, Call::rename}) {
        fault = {call, 1, EIO};
        EXPECT_NE(complaint(path, "new"), "");
        EXPECT_EQ(folder.file_count(), 0u);
    }
}

TEST_F(SaveFile, TellsWhenTheFolderIsNotOnDisk) {
    put(path, "old");
    fault = {Call::fsync, 2, EIO};
    EXPECT_NE(complaint(path, "new"), "");
    expect_only("new");
}

TEST_F(SaveFile, GoesOnAfterInterruptionsAndShortWrites) {
    const std::string text(100000, 'x');
    for (const auto& [call, error] : {std::pair(Call::write, EINTR), std::pair(Call::fsync, EINTR),
                                      std::pair(Call::write, short_write)}) {
        put(path, "old");
        fault = {call, 1, error};
        save_file(path, text);
        EXPECT_EQ(fault.call, Call::none);  // it did strike
        expect_only(text);
    }
}

TEST_F(SaveFile, LeavesTheOldFileAtTheLimitOfFileSizes) {
    put(path, "old");
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{50000, 50000};
        setrlimit(RLIMIT_FSIZE, &limit);
        _exit(complaint(path, std::string(100000, 'x')).empty() ? 0 : 2);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 2);
    expect_only("old");
}

// What is in the file after a writer died at the `countdown`-th call.
std::string left_by_death_at(Call call, int countdown, const std::string& path) {
    put(path, "old");
    const pid_t child = fork();
    if (child == 0) {
        fault = {call, countdown, killed};
        save_file(path, "new");
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    return contents_of(path);
}

TEST_F(SaveFile, TheNewFileAppearsWithItsNameAndWhole) {
    EXPECT_EQ(left_by_death_at(Call::write, 1, path), "old");
    EXPECT_EQ(left_by_death_at(Call::fsync, 1, path), "old");
    EXPECT_EQ(left_by_death_at(Call::rename, 1, path), "old");
    EXPECT_EQ(left_by_death_at(Call::fsync, 2, path), "new");  // of the folder
    EXPECT_EQ(folder.file_count(), 4u);  // three died too early to clear up, all in this folder
}

// A process that saves the two texts in turn until it is killed; it has begun when this returns.
pid_t endless_writer(const std::string& path, std::span<const std::string, 2> texts) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        EXPECT_EQ(write(ends[1], "!", 1), 1);
        for (unsigned n = 0;; ++n)
            save_file(path, texts[n % 2]);
    }
    char begun = 0;
    EXPECT_EQ(read(ends[0], &begun, 1), 1);
    close(ends[0]);
    close(ends[1]);
    return child;
}

TEST_F(SaveFile, AWriterKilledAtAnyTimeLeavesOneOfItsFilesWhole) {
    std::mt19937 random(1);
    const std::string texts[] = {std::string(300000, 'a'), std::string(200000, 'b')};
    save_file(path, texts[1]);
    for (int i = 0; i < 250; ++i) {
        const pid_t child = endless_writer(path, texts);
        usleep(static_cast<useconds_t>(random() % 4000));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::string found = contents_of(path);
        ASSERT_TRUE(found == texts[0] || found == texts[1]) << found.size();
    }
    save_file(path, "after");
    EXPECT_EQ(contents_of(path), "after");
}

TEST_F(SaveFile, StepsOverTheLeftoversOfOthers) {
    for (int i = 0; i < 3; ++i) {
        put(folder / (".scanlight-" + std::to_string(getpid()) + "-" + std::to_string(i)),
            "theirs");
    }
    save_file(path, "mine");
    EXPECT_EQ(contents_of(path), "mine");
    EXPECT_EQ(folder.file_count(), 4u);
}

TEST_F(SaveFile, GivesTheModeThatUsersExpect) {
    const mode_t old_mask = umask(027);
    save_file(path, "new");
    umask(old_mask);
    EXPECT_EQ(mode_of(path), 0640u);
    chmod(path.c_str(), 0604);
    save_file(path, "newer");
    EXPECT_EQ(mode_of(path), 0604u);
}

// Root may write everything: tried by an ordinary user, in a process of its own.
bool is_refused_to_a_user(const std::string& path) {
    const pid_t child = fork();
    if (child == 0) {
        const bool is_user = geteuid() != 0 || seteuid(65534) == 0;
        const bool refused =
            complaint(path, "new") == path + ": cannot be written: Permission denied";
        _exit(is_user && refused ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(SaveFile, RespectsAFileThatMayNotBeWritten) {
    put(path, "old");
    chmod(path.c_str(), 0444);
    chmod((folder / "").c_str(), 0777);
    EXPECT_TRUE(is_refused_to_a_user(path));
    expect_only("old");
}

TEST_F(SaveFile, RefusesAFolderThatMayNotBeWritten) {
    chmod((folder / "").c_str(), 0555);
    EXPECT_TRUE(is_refused_to_a_user(path));
    EXPECT_EQ(folder.file_count(), 0u);
    chmod((folder / "").c_str(), 0755);
}

TEST_F(SaveFile, RefusesFoldersAndMissingOnes) {
    EXPECT_EQ(complaint(folder / "", "new"), folder / "" + ": cannot be written: Is a directory");
    EXPECT_EQ(complaint(folder / "no/such", "new"),
              folder / "no/such" + ": cannot be written: No such file or directory");
    EXPECT_NE(complaint("", "new"), "");
    put(path, "old");
    EXPECT_NE(complaint(path + "/", "new"), "");
    EXPECT_NE(complaint(path + "/a", "new"), "");
    EXPECT_NE(complaint(folder / std::string(300, 'n'), "new"), "");
    expect_only("old");
}

TEST_F(SaveFile, WritesThroughALink) {
    put(path, "old");
    const std::string link = folder / "link";
    const std::string chain = folder / "chain";
    std::filesystem::create_symlink("out.png", link);
    std::filesystem::create_symlink(link, chain);
    save_file(chain, "new");
    EXPECT_EQ(contents_of(path), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_TRUE(std::filesystem::is_symlink(chain));
    std::filesystem::remove(path);
    save_file(link, "made");
    EXPECT_EQ(contents_of(path), "made");
    EXPECT_EQ(folder.file_count(), 3u);
}

TEST_F(SaveFile, RefusesALinkToItself) {
    std::filesystem::create_symlink("out.png", path);
    EXPECT_NE(complaint(path, "new"), "");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST_F(SaveFile, WritesDevicesInPlaceAndTellsWhenTheyAreFull) {
    EXPECT_EQ(complaint("/dev/null", "new"), "");
    EXPECT_EQ(complaint("/dev/full", "new"),
              "/dev/full: cannot be written: No space left on device");
    std::filesystem::create_symlink("/dev/full", path);
    EXPECT_NE(complaint(path, "new"), "");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(SaveFile, WritesIntoAPipeOfAName) {
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
    save_file(path, "through");
    char text[16] = {};
    EXPECT_EQ(read(reader, text, sizeof text), 7);
    EXPECT_STREQ(text, "through");
    close(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(path));
}

// Runs a save to standard output into `fd` in a process of its own: 0 written, 2 refused; killed by
// a signal otherwise.
int save_to_standard_output(int fd, std::string_view text) {
    std::fflush(stdout);  // or the child writes what waits there, too
    const pid_t child = fork();
    if (child == 0) {
        dup2(fd, STDOUT_FILENO);
        signal(SIGPIPE, SIG_DFL);
        const bool refused = !complaint("-", text).empty();
        sigset_t pending;
        sigpending(&pending);
        _exit(sigismember(&pending, SIGPIPE) == 1 ? 3 : refused ? 2 : 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST_F(SaveFile, ADashIsStandardOutput) {
    put(path, "");
    const int out = open(path.c_str(), O_WRONLY);
    EXPECT_EQ(save_to_standard_output(out, "data"), 0);
    close(out);
    expect_only("data");
}

TEST_F(SaveFile, AClosedPipeIsAnErrorAndNoSignal) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    close(ends[0]);
    EXPECT_EQ(save_to_standard_output(ends[1], std::string(1 << 20, 'x')), 2);
    close(ends[1]);
}

TEST_F(SaveFile, AFullStandardOutputIsAnError) {
    const int full = open("/dev/full", O_WRONLY);
    EXPECT_EQ(save_to_standard_output(full, "data"), 2);
    close(full);
}

}  // namespace
}  // namespace scanlight::raster

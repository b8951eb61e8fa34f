#include "raster/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>

#include "tests/raster/cases.h"

namespace scanlight::raster {
namespace {

constexpr int worker_counts[] = {1, 2, 3, 7, 16};
constexpr std::size_t piece_counts[] = {0, 1, 2, 5, 16, 1000};

TEST(Workers, AreAsManyAsAskedFor) {
    for (const int count : worker_counts)
        EXPECT_EQ(Workers(count).count(), count);
    EXPECT_GE(Workers().count(), 1);
}

TEST(Workers, DoEachPieceOnceAndTheCallerSeesIt) {
    for (const int count : worker_counts) {
        Workers workers(count);
        for (int again = 0; again < laws::cases(100); ++again) {
            for (const std::size_t pieces : piece_counts) {
                // Plain integers: that no two threads touch one, and that all is written when the
                // call returns, is for the workers to see to.
                std::vector<int> done(pieces, 0);
                workers.for_each(pieces, [&](int, std::size_t i) { ++done[i]; });
                ASSERT_EQ(done, std::vector<int>(pieces, 1)) << count << " workers";
            }
        }
    }
}

TEST(Workers, HaveNumbersThatNoTwoPiecesHoldAtOnce) {
    for (const int count : worker_counts) {
        Workers workers(count);
        // Plain again: whoever holds a number has its place to himself.
        std::vector<std::size_t> pieces_of(static_cast<std::size_t>(count), 0);
        std::vector<std::atomic<bool>> busy(static_cast<std::size_t>(count));
        std::atomic<int> clashes{0};
        workers.for_each(2000, [&](int worker, std::size_t) {
            const auto w = static_cast<std::size_t>(worker);
            if (busy.at(w).exchange(true)) ++clashes;
            ++pieces_of[w];
            busy[w] = false;
        });
        EXPECT_EQ(clashes, 0);
        std::size_t sum = 0;
        for (const std::size_t pieces : pieces_of)
            sum += pieces;
        EXPECT_EQ(sum, 2000u);
    }
}

TEST(Workers, WorkAllAtTheSameTime) {
    for (const int count : worker_counts) {
        Workers workers(count);
        std::latch all_here(count);  // one worker too few, and nobody would ever leave
        workers.for_each(static_cast<std::size_t>(count),
                         [&](int, std::size_t) { all_here.arrive_and_wait(); });
        EXPECT_TRUE(all_here.try_wait());
    }
}

std::string error_of(Workers& workers, std::size_t pieces,
                     const std::function<void(int, std::size_t)>& piece) {
    try {
        workers.for_each(pieces, piece);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(Workers, PassOnAnExceptionAndBeginNothingMore) {
    for (const int count : worker_counts) {
        Workers workers(count);
        std::atomic<std::size_t> begun{0};
        const auto error = error_of(workers, 1'000'000, [&](int, std::size_t i) {
            ++begun;
            if (i == 10) throw std::runtime_error("the tenth");
        });
        EXPECT_EQ(error, "the tenth");
        EXPECT_LT(begun, 1'000'000u) << count << " workers";
    }
}

TEST(Workers, PassOnAnExceptionOfAnotherThread) {
    for (const int count : {2, 3, 16}) {
        Workers workers(count);
        std::atomic<bool> thrown{false};
        const auto error = error_of(workers, 1000, [&](int worker, std::size_t) {
            if (worker != 0) {
                thrown = true;
                throw std::runtime_error("not the caller");
            }
            while (!thrown)
                std::this_thread::yield();
        });
        EXPECT_EQ(error, "not the caller");
    }
}

TEST(Workers, GoOnAfterAnException) {
    for (const int count : worker_counts) {
        Workers workers(count);
        for (int again = 0; again < laws::cases(100); ++again) {
            const auto fail = [](int, std::size_t i) {
                throw std::runtime_error(std::to_string(i));
            };
            EXPECT_NE(error_of(workers, 20, fail), "none");
            std::vector<int> done(50, 0);
            workers.for_each(done.size(), [&](int, std::size_t i) { ++done[i]; });
            ASSERT_EQ(done, std::vector<int>(50, 1)) << count << " workers";
        }
    }
}

TEST(Workers, MayLeaveWithoutWork) {
    for (int i = 0; i < laws::cases(200); ++i)
        EXPECT_EQ(Workers(5).count(), 5);
}

}  // namespace
}  // namespace scanlight::raster

#include "bench/peers/links.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace soms::bench {

namespace {

void one_by_one(std::span<const std::unique_ptr<Match>> matches, const Questions& questions,
                std::span<double> answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < matches.size() && !(questions.job == Job::any && sum != 0); ++k) {
      double found = 0;
      matches[k]->answer({questions.job, questions.poses.subspan(i * matches.size() + k, 1)},
                         {&found, 1});
      sum += found;
    }
    answers[i] = sum;
  }
}

void link_by_link(std::span<const std::unique_ptr<Match>> matches, const Questions& questions,
                  std::span<double> answers) {
  std::vector<std::size_t> open(answers.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::fill(answers.begin(), answers.end(), 0.0);
  std::vector<Pose> poses;
  std::vector<double> found;
  for (std::size_t k = 0; k < matches.size() && !open.empty(); ++k) {
    poses.clear();
    for (const std::size_t i : open) {
      poses.push_back(questions.poses[i * matches.size() + k]);
    }
    found.resize(open.size());
    matches[k]->answer({questions.job, poses}, found);
    for (std::size_t j = 0; j < open.size(); ++j) {
      answers[open[j]] += found[j];
    }
    if (questions.job == Job::any) {
      std::erase_if(open, [&](std::size_t i) { return answers[i] != 0; });
    }
  }
}

}  // namespace

void answer_links(std::span<const std::unique_ptr<Match>> matches, const Questions& questions,
                  bool batches, std::span<double> answers) {
  (batches ? link_by_link : one_by_one)(matches, questions, answers);
}

}  // namespace soms::bench

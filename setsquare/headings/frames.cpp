// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

/// The highest confidence among a keyframe's proposals.
double belief_of(const HeadingEvidence& keyframe) {
  double belief = 0.0;
  for (const HeadingProposal& proposal : keyframe.proposals) {
    belief = std::max(belief, proposal.confidence);
  }
  return belief;
}

constexpr auto kNoFrame = static_cast<std::size_t>(-1);

/// The keyframes between two changes of the trace.
struct SteadyPiece {
  std::size_t begin = 0;
  std::size_t end = 0;
  double first_rad = 0.0;      ///< Offset at its first keyframe ...
  double last_rad = 0.0;       ///< ... and at its last one.
  double num_keyframes = 0.0;  ///< Each by its share of its place.
  double support = 0.0;
  bool tells = false;  ///< Whether its support suffices to determine its frame.
};

std::vector<SteadyPiece> pieces_between_changes(const std::vector<HeadingEvidence>& keyframes,
                                                const HeadingTrace& trace,
                                                const HeadingTraceParams& params) {
  std::vector<SteadyPiece> pieces;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    if (k == 0 || trace.is_change[k])
      pieces.push_back({.begin = k, .first_rad = trace.offset_rad[k]});
    pieces.back().end = k + 1;
    pieces.back().last_rad = trace.offset_rad[k];
    pieces.back().num_keyframes += keyframes[k].share_of_place;
    pieces.back().support +=
        belief_of(keyframes[k]) - passing_cost(keyframes[k], trace.offset_rad[k], params);
  }
  return pieces;
}

void judge_support(std::vector<SteadyPiece>& pieces, const HeadingFramesParams& params) {
  bool any_tells = false;
  for (SteadyPiece& piece : pieces) {
    piece.tells =
        piece.support >= std::max(params.min_support, params.min_share * piece.num_keyframes);
    any_tells = any_tells || piece.tells;
  }
  if (any_tells || pieces.empty()) return;
  const auto has_less = [](const SteadyPiece& a, const SteadyPiece& b) {
    return a.support < b.support;
  };
  std::max_element(pieces.begin(), pieces.end(), has_less)->tells = true;
}

/// True of an excursion: after the piece the walls' offset is what it was before. Two slips do not
/// make up for each other; an oblique wall, seen for a while, does that.
bool is_soon_undone(const std::vector<SteadyPiece>& pieces,
                    std::size_t p,
                    double period_rad,
                    const HeadingFramesParams& params) {
  if (p == 0 || p + 1 == pieces.size()) return false;
  if (pieces[p].num_keyframes > static_cast<double>(params.max_excursion)) return false;
  const double left_rad = pieces[p].first_rad - pieces[p - 1].last_rad;
  const double back_rad = pieces[p + 1].first_rad - pieces[p].last_rad;
  return std::abs(wrap_to_period(left_rad + back_rad, period_rad)) < params.same_frame_rad;
}

std::vector<double> step_sigmas(const std::vector<HeadingEvidence>& keyframes) {
  constexpr double kMinStepSigma_rad = 1e-6;
  std::vector<double> sigma_rad;
  sigma_rad.reserve(keyframes.size());
  for (const HeadingEvidence& keyframe : keyframes) {
    sigma_rad.push_back(std::max(keyframe.step_sigma_rad, kMinStepSigma_rad));
  }
  return sigma_rad;
}

/// The nearest frame: the preceding one, but for a slip, or one seen earlier; a new one where none
/// is near enough. Without a preceding frame, `before` is no valid index.
std::size_t frame_at(double offset_rad,
                     std::size_t before,
                     double period_rad,
                     const HeadingFramesParams& params,
                     std::vector<HeadingFrame>& frames) {
  std::size_t nearest = frames.size();
  double least_rad = period_rad;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const double miss_rad = std::abs(wrap_to_period(offset_rad - frames[f].offset_rad, period_rad));
    if (miss_rad >= (f == before ? params.min_separation_rad : params.same_frame_rad)) continue;
    if (miss_rad >= least_rad) continue;
    least_rad = miss_rad;
    nearest = f;
  }
  if (nearest == frames.size()) frames.push_back({.offset_rad = offset_rad});
  return nearest;
}

/// The main frame first and at 0.
void rank(std::vector<HeadingFrame>& frames, double period_rad, std::vector<double>& drift_rad) {
  if (frames.empty()) frames.push_back({});
  sort_by_greatest(frames, &HeadingFrame::support);
  const double main_rad = frames.front().offset_rad;
  for (HeadingFrame& frame : frames) {
    frame.offset_rad = wrap_to_period(frame.offset_rad - main_rad, period_rad);
  }
  for (double& drift : drift_rad) drift += main_rad;
}

double explained_share(const std::vector<HeadingEvidence>& keyframes,
                       const std::vector<HeadingFrame>& frames) {
  double belief = 0.0;
  for (const HeadingEvidence& keyframe : keyframes) belief += belief_of(keyframe);
  double support = 0.0;
  for (const HeadingFrame& frame : frames) support += frame.support;
  return belief > 0.0 ? std::min(support / belief, 1.0) : 1.0;
}

/// Lays pieces end to end.
class PieceChain {
 public:
  PieceChain(const HeadingTrace& trace, double period_rad, const HeadingFramesParams& params)
      : trace_(trace), period_rad_(period_rad), params_(params) {}

  void add(const SteadyPiece& piece, bool is_no_slip, HeadingFrames& found) {
    const std::size_t before = std::exchange(frame_, kNoFrame);
    double step_rad = 0.0;
    if (piece.tells) {
      frame_ = frame_at(piece.first_rad - drift_rad_,
                        is_no_slip ? kNoFrame : before,
                        period_rad_,
                        params_,
                        found.frames);
      step_rad = wrap_to_period(piece.first_rad - found.frames[frame_].offset_rad - drift_rad_,
                                period_rad_);
      found.frames[frame_].support += piece.support;
    }
    if (frame_ == before && is_no_slip) {
      frame_ = kNoFrame;  // A jump too small for a new frame: the drift stays.
      step_rad = 0.0;
    } else if (frame_ == before && std::abs(step_rad) > params_.min_slip_rad) {
      double& sigma_rad = found.step_sigma_rad[piece.begin];
      sigma_rad = std::max(sigma_rad, std::abs(step_rad));
    }
    for (std::size_t k = piece.begin; k < piece.end; ++k) {
      found.drift_rad[k] = drift_rad_ + step_rad + trace_.offset_rad[k] - piece.first_rad;
    }
    drift_rad_ = found.drift_rad[piece.end - 1];
  }

 private:
  const HeadingTrace& trace_;
  double period_rad_;
  const HeadingFramesParams& params_;
  std::size_t frame_ = kNoFrame;  ///< Of the piece before, if that gave one.
  double drift_rad_ = 0.0;        ///< At the end of the piece before.
};

}  // namespace

void HeadingFramesParams::validate() const {
  if (!(min_separation_rad > 0.0)) throw ParameterError("min_separation_rad", "must be positive");
  if (!(same_frame_rad > 0.0)) throw ParameterError("same_frame_rad", "must be positive");
  if (!(min_slip_rad > 0.0)) throw ParameterError("min_slip_rad", "must be positive");
  if (!(min_support >= 0.0)) throw ParameterError("min_support", "must not be negative");
  if (!(min_share >= 0.0)) throw ParameterError("min_share", "must not be negative");
}

HeadingFrames find_heading_frames(const std::vector<HeadingEvidence>& keyframes,
                                  const HeadingTrace& trace,
                                  const HeadingTraceParams& trace_params,
                                  const HeadingFramesParams& params) {
  const double period_rad = trace_params.period_rad;
  std::vector<SteadyPiece> pieces = pieces_between_changes(keyframes, trace, trace_params);
  judge_support(pieces, params);
  HeadingFrames found{.frames = {},
                      .drift_rad = std::vector<double>(keyframes.size()),
                      .step_sigma_rad = step_sigmas(keyframes)};
  PieceChain chain(trace, period_rad, params);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const bool is_no_slip = keyframes[pieces[p].begin].is_step_confirmed ||
                            is_soon_undone(pieces, p, period_rad, params);
    chain.add(pieces[p], is_no_slip, found);
  }
  found.share = explained_share(keyframes, found.frames);
  rank(found.frames, period_rad, found.drift_rad);
  return found;
}

}  // namespace setsquare

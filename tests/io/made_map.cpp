// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/made_map.hpp"

#include <bit>
#include <limits>
#include <random>
#include <sstream>

#include "tests/io/made_sessions.hpp"

namespace setsquare::testing {
namespace {

/// By the bits of the generator alone: the standard's distributions differ from library to library.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}

  double number() { return static_cast<double>(bits_() >> 11) * 0x1p-53 * 20.0 - 10.0; }
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(bits_() % end); }
  bool coin() { return bits_() % 2 == 0; }
  Pose2 pose() { return {number(), number(), number()}; }
  Timestamp stamp() { return {static_cast<std::int64_t>(bits_() >> 2)}; }
  template <typename Enum>
  Enum any(Enum last) {
    return static_cast<Enum>(below(static_cast<std::size_t>(last) + 1));
  }
  std::string word() {
    std::string text(below(12), ' ');
    for (char& letter : text) letter = static_cast<char>(bits_());
    return text;
  }
  /// A number, or one of those that are none.
  double any_number() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    switch (below(8)) {
      case 0:
        return kInfinity;
      case 1:
        return std::numeric_limits<double>::quiet_NaN();
      case 2:
        return -0.0;
      default:
        return number();
    }
  }

 private:
  std::mt19937_64 bits_;
};

MappedScan drawn_scan(Draw& draw) {
  MappedScan scan;
  scan.stamp = draw.stamp();
  scan.status = draw.any(TrackStatus::kLost);
  scan.is_placed = draw.coin();
  scan.T_map_sensor = draw.pose();
  scan.T_map_base = draw.pose();
  scan.score = draw.any_number();
  scan.has_odometry = draw.coin();
  scan.open_sigma_m = {draw.number(), draw.number()};
  scan.is_turn_open = draw.coin();
  scan.open_turn_sigma_rad = draw.number();
  scan.open_turn_motion_m = {draw.number(), draw.number()};
  scan.position_sigma_m = draw.any_number();
  for (double& value : scan.position_covariance_m2.reshaped()) value = draw.any_number();
  scan.heading_sigma_rad = draw.any_number();
  return scan;
}

/// Ranges as logs have them: decimals, floats, anything.
double drawn_range(Draw& draw, std::size_t kind) {
  if (draw.below(20) == 0) return draw.any_number();
  const double range_m = 30.0 * draw.share();
  if (kind == 0) return static_cast<double>(static_cast<int>(100.0 * range_m)) / 100.0;
  if (kind == 1) return double{static_cast<float>(range_m)};
  return range_m;
}

std::shared_ptr<const Scan> drawn_sweep(Draw& draw) {
  const auto scan = std::make_shared<Scan>();
  scan->stamp = draw.stamp();
  scan->first_bearing_rad = draw.number();
  scan->bearing_step_rad = draw.coin() ? 0.01 : -0.02;
  scan->min_range_m = draw.share();
  scan->max_range_m = 2.0 + draw.share();
  const std::size_t kind = draw.below(3);
  for (std::size_t i = draw.below(40); i > 0; --i) {
    scan->ranges_m.push_back(drawn_range(draw, kind));
  }
  scan->T_base_sensor = draw.pose();
  scan->time_increment_s = draw.number();
  scan->scan_time_s = draw.number();
  scan->scanner = static_cast<std::uint32_t>(draw.below(5));
  return scan;
}

/// Consecutive scans of a map of so many.
template <typename Stretch>
void draw_scans(Draw& draw, std::size_t num_scans, Stretch& stretch) {
  stretch.first_scan = draw.below(num_scans);
  stretch.num_scans = draw.below(num_scans - stretch.first_scan + 1);
}

void draw_keyframes(Draw& draw, Map& map) {
  const std::size_t num_scans = map.scans.size();
  for (std::size_t i = 0; i < 2; ++i) {
    map.frames.push_back({draw.number(), draw.number(), draw.number()});
  }
  for (std::size_t i = draw.below(3); i < num_scans; i += 1 + draw.below(4)) {
    map.keyframes.push_back(i);
    MappedHeading heading{.tracked_rad = draw.number(),
                          .measured_rad = {},
                          .information_per_rad2 = draw.number(),
                          .weight = draw.share(),
                          .frame = draw.below(map.frames.size())};
    if (draw.coin()) heading.measured_rad = draw.number();
    map.headings.push_back(heading);
    map.kept_scans.push_back({i, drawn_sweep(draw)});
    if (draw.coin()) map.kept_scans.push_back({draw.below(num_scans), map.kept_scans[0].scan});
  }
}

void draw_track(Draw& draw, Map& map) {
  const std::size_t num_scans = map.scans.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t first = i * num_scans / 3;
    const std::size_t end = (i + 1) * num_scans / 3;
    if (first < end) map.pieces.push_back({first, end - first, draw.coin()});
    OpenStretch stretch{.way_m = draw.number(),
                        .duration_s = draw.number(),
                        .direction_rad = draw.number(),
                        .has_odometry = draw.coin(),
                        .length_sigma_m = draw.any_number(),
                        .is_turn = draw.coin(),
                        .heading_sigma_rad = draw.number()};
    draw_scans(draw, num_scans, stretch);
    map.open_stretches.push_back(stretch);
    map.undecided_turns.push_back({draw.below(num_scans), draw.below(num_scans), draw.number()});
    MapDoubt doubt{.kind = draw.any(DoubtKind::kMirrored),
                   .place_m = {draw.number(), draw.number()},
                   .first_stamp = draw.stamp(),
                   .last_stamp = draw.stamp(),
                   .reason = draw.word()};
    draw_scans(draw, num_scans, doubt);
    map.doubts.push_back(doubt);
  }
  for (std::size_t i = 0; i < num_scans / 2; ++i) {
    map.closures.push_back({{.stamp_i = draw.stamp(),
                             .stamp_j = draw.stamp(),
                             .T_i_j = draw.pose(),
                             .axes = draw.any(ClosureAxes::kY),
                             .is_accepted = draw.coin(),
                             .weight = draw.share(),
                             .reason = draw.word()},
                            draw.below(num_scans),
                            draw.below(num_scans)});
  }
}

void draw_graph(Draw& draw, PoseGraph& graph) {
  for (std::size_t i = 0; i < 4; ++i) graph.T_map_node.push_back(draw.pose());
  for (std::size_t i = 0; i < 3; ++i) {
    Constraint constraint{.from = i,
                          .to = i + 1,
                          .T_from_to = draw.pose(),
                          .kind = draw.any(ConstraintKind::kLoopClosure),
                          .weight = draw.share(),
                          .source = draw.below(1000)};
    for (double& value : constraint.information.reshaped()) value = draw.share();
    graph.constraints.push_back(constraint);
    graph.headings.push_back({i, draw.number(), draw.share()});
  }
}

void draw_reports(Draw& draw, Map& map) {
  for (std::uint32_t scanner = 0; scanner < 2; ++scanner) {
    map.scanners.push_back({.scanner = scanner,
                            .verdict = draw.any(MountingVerdict::kUnfit),
                            .num_scans = draw.below(100),
                            .num_mapped = draw.below(100),
                            .num_sightings = draw.below(100),
                            .T_base_sensor = draw.pose(),
                            .T_base_seen = draw.pose(),
                            .sigma_rad = draw.number(),
                            .sigma_m = draw.any_number()});
  }
  map.gyro = {.verdict = draw.any(GyroVerdict::kUnlike),
              .num_samples = draw.below(100),
              .num_turns = draw.below(100),
              .scale = draw.number(),
              .scans_late_s = draw.number(),
              .bias_rad_per_s = draw.number()};
  const auto comparison = [&]() -> OdometryComparison {
    return {draw.below(100), draw.number(), draw.number()};
  };
  map.odometry = {.verdict = draw.any(OdometryVerdict::kUnlike),
                  .way = comparison(),
                  .turn = comparison(),
                  .num_ignored = draw.below(100),
                  .num_jumps = draw.below(100),
                  .num_carried = draw.below(100)};
  map.sweep = {.verdict = draw.any(SweepVerdict::kAtOnce),
               .sweep_s = draw.number(),
               .stated_s = draw.number(),
               .num_turns = draw.below(100)};
  map.num_with_odometry = draw.below(100);
  if (draw.coin()) {
    map.audit = AuditReport{.num_pairs = draw.below(100),
                            .num_matched = draw.below(100),
                            .num_agreeing = draw.below(100),
                            .num_contradicting = draw.below(100),
                            .num_seconded = draw.below(100)};
  }
}

/// Lines of names and values, numbers by their bits.
class Listing {
 public:
  void add(const char* name, double value) { line(name) << std::bit_cast<std::uint64_t>(value); }
  void add(const char* name, const std::string& text) { line(name) << text.size() << ' ' << text; }
  void add(const char* name, const Pose2& pose) {
    add(name, pose.x_m);
    add(name, pose.y_m);
    add(name, pose.theta_rad);
  }
  void add(const char* name, Timestamp stamp) { add(name, stamp.ns); }
  template <typename Value>
  void add(const char* name, const Value& value) {
    if constexpr (requires { value.reshaped(); }) {
      for (const double entry : value.reshaped()) add(name, entry);
    } else {
      line(name) << static_cast<std::int64_t>(value);
    }
  }

  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostream& line(const char* name) { return text_ << '\n' << name << ' '; }

  std::ostringstream text_;
};

void list(Listing& out, const MappedScan& scan) {
  out.add("stamp", scan.stamp);
  out.add("status", scan.status);
  out.add("is_placed", scan.is_placed);
  out.add("T_map_sensor", scan.T_map_sensor);
  out.add("T_map_base", scan.T_map_base);
  out.add("score", scan.score);
  out.add("has_odometry", scan.has_odometry);
  out.add("open_sigma_m", scan.open_sigma_m);
  out.add("is_turn_open", scan.is_turn_open);
  out.add("open_turn_sigma_rad", scan.open_turn_sigma_rad);
  out.add("open_turn_motion_m", scan.open_turn_motion_m);
  out.add("position_sigma_m", scan.position_sigma_m);
  out.add("position_covariance_m2", scan.position_covariance_m2);
  out.add("heading_sigma_rad", scan.heading_sigma_rad);
}

void list(Listing& out, const Scan& scan) {
  out.add("stamp", scan.stamp);
  out.add("first_bearing_rad", scan.first_bearing_rad);
  out.add("bearing_step_rad", scan.bearing_step_rad);
  out.add("min_range_m", scan.min_range_m);
  out.add("max_range_m", scan.max_range_m);
  for (const double range_m : scan.ranges_m) out.add("range_m", range_m);
  out.add("T_base_sensor", scan.T_base_sensor);
  out.add("time_increment_s", scan.time_increment_s);
  out.add("scan_time_s", scan.scan_time_s);
  out.add("scanner", scan.scanner);
}

void list(Listing& out, const MappedHeading& heading) {
  out.add("tracked_rad", heading.tracked_rad);
  out.add("is_measured", heading.measured_rad.has_value());
  out.add("measured_rad", heading.measured_rad.value_or(0.0));
  out.add("information_per_rad2", heading.information_per_rad2);
  out.add("weight", heading.weight);
  out.add("frame", heading.frame);
}

void list(Listing& out, const BuildingFrame& frame) {
  out.add("offset_rad", frame.offset_rad);
  out.add("sigma_rad", frame.sigma_rad);
  out.add("support", frame.support);
}

void list(Listing& out, const TrackPiece& piece) {
  out.add("first_scan", piece.first_scan);
  out.add("num_scans", piece.num_scans);
  out.add("is_joined", piece.is_joined);
}

void list(Listing& out, const MappedClosure& mapped) {
  out.add("stamp_i", mapped.closure.stamp_i);
  out.add("stamp_j", mapped.closure.stamp_j);
  out.add("T_i_j", mapped.closure.T_i_j);
  out.add("axes", mapped.closure.axes);
  out.add("is_accepted", mapped.closure.is_accepted);
  out.add("weight", mapped.closure.weight);
  out.add("reason", mapped.closure.reason);
  out.add("scan_i", mapped.scan_i);
  out.add("scan_j", mapped.scan_j);
}

void list(Listing& out, const OpenStretch& stretch) {
  out.add("first_scan", stretch.first_scan);
  out.add("num_scans", stretch.num_scans);
  out.add("way_m", stretch.way_m);
  out.add("duration_s", stretch.duration_s);
  out.add("direction_rad", stretch.direction_rad);
  out.add("has_odometry", stretch.has_odometry);
  out.add("length_sigma_m", stretch.length_sigma_m);
  out.add("is_turn", stretch.is_turn);
  out.add("heading_sigma_rad", stretch.heading_sigma_rad);
}

void list(Listing& out, const UndecidedTurn& turn) {
  out.add("first_scan", turn.first_scan);
  out.add("last_scan", turn.last_scan);
  out.add("turned_rad", turn.turned_rad);
}

void list(Listing& out, const MapDoubt& doubt) {
  out.add("kind", doubt.kind);
  out.add("place_m", doubt.place_m);
  out.add("first_scan", doubt.first_scan);
  out.add("num_scans", doubt.num_scans);
  out.add("first_stamp", doubt.first_stamp);
  out.add("last_stamp", doubt.last_stamp);
  out.add("reason", doubt.reason);
}

void list(Listing& out, const MappedScanner& scanner) {
  out.add("scanner", scanner.scanner);
  out.add("verdict", scanner.verdict);
  out.add("num_scans", scanner.num_scans);
  out.add("num_mapped", scanner.num_mapped);
  out.add("num_sightings", scanner.num_sightings);
  out.add("T_base_sensor", scanner.T_base_sensor);
  out.add("T_base_seen", scanner.T_base_seen);
  out.add("sigma_rad", scanner.sigma_rad);
  out.add("sigma_m", scanner.sigma_m);
}

void list(Listing& out, const OdometryComparison& comparison) {
  out.add("num_compared", comparison.num_compared);
  out.add("scale", comparison.scale);
  out.add("deviation", comparison.deviation);
}

void list(Listing& out, const Constraint& constraint) {
  out.add("from", constraint.from);
  out.add("to", constraint.to);
  out.add("T_from_to", constraint.T_from_to);
  out.add("information", constraint.information);
  out.add("kind", constraint.kind);
  out.add("weight", constraint.weight);
  out.add("source", constraint.source);
}

void list(Listing& out, const HeadingMeasurement& heading) {
  out.add("node", heading.node);
  out.add("heading_rad", heading.heading_rad);
  out.add("information_per_rad2", heading.information_per_rad2);
}

template <typename Value>
void list_each(Listing& out, const char* name, const std::vector<Value>& values) {
  out.add(name, values.size());
  for (const Value& value : values) list(out, value);
}

void list_reports(Listing& out, const Map& map) {
  list_each(out, "scanners", map.scanners);
  out.add("gyro.verdict", map.gyro.verdict);
  out.add("gyro.num_samples", map.gyro.num_samples);
  out.add("gyro.num_turns", map.gyro.num_turns);
  out.add("gyro.scale", map.gyro.scale);
  out.add("gyro.scans_late_s", map.gyro.scans_late_s);
  out.add("gyro.bias_rad_per_s", map.gyro.bias_rad_per_s);
  out.add("odometry.verdict", map.odometry.verdict);
  list(out, map.odometry.way);
  list(out, map.odometry.turn);
  out.add("odometry.num_ignored", map.odometry.num_ignored);
  out.add("odometry.num_jumps", map.odometry.num_jumps);
  out.add("odometry.num_carried", map.odometry.num_carried);
  out.add("sweep.verdict", map.sweep.verdict);
  out.add("sweep.sweep_s", map.sweep.sweep_s);
  out.add("sweep.stated_s", map.sweep.stated_s);
  out.add("sweep.num_turns", map.sweep.num_turns);
  out.add("num_with_odometry", map.num_with_odometry);
  if (map.num_forgotten > 0) out.add("num_forgotten", map.num_forgotten);
  for (std::size_t i = 0; i < map.forgotten_poses.size(); ++i) {
    const std::string name = "forgotten_poses[" + std::to_string(i) + "].";
    out.add((name + "next_scan").c_str(), map.forgotten_poses[i].next_scan);
    out.add((name + "num_scans").c_str(), map.forgotten_poses[i].num_scans);
    out.add((name + "way_m").c_str(), map.forgotten_poses[i].way_m);
  }
  out.add("is_audited", map.audit.has_value());
  const AuditReport audit = map.audit.value_or(AuditReport{});
  out.add("audit.num_pairs", audit.num_pairs);
  out.add("audit.num_matched", audit.num_matched);
  out.add("audit.num_agreeing", audit.num_agreeing);
  out.add("audit.num_contradicting", audit.num_contradicting);
  out.add("audit.num_seconded", audit.num_seconded);
}

void list_record(Listing& out, const MapRecord& record) {
  out.add("title", record.title);
  out.add("pose_of", record.pose_of);
  out.add("version", record.run.version);
  out.add("log", record.run.log);
  out.add("format", record.run.format);
  out.add("sensor", record.run.sensor);
  for (const auto& [scanner, name] : record.run.scanner_names) {
    out.add("scanner", scanner);
    out.add("name", name);
  }
  out.add("preset", record.run.preset);
  out.add("options_json", record.run.options_json);
  out.add("parameters_json", record.run.parameters_json);
  out.add("findings_json", record.run.findings_json);
  out.add("num_damaged_records", record.run.num_damaged_records);
}

}  // namespace

SavedMap made_map(std::uint64_t seed, std::size_t num_scans) {
  Draw draw(seed);
  SavedMap saved;
  Map& map = saved.map;
  for (std::size_t i = 0; i < num_scans; ++i) map.scans.push_back(drawn_scan(draw));
  draw_keyframes(draw, map);
  draw_track(draw, map);
  draw_graph(draw, map.graph);
  draw_reports(draw, map);
  saved.record.title = draw.word();
  saved.record.pose_of = draw.any(PoseOf::kSensor);
  RunRecord& run = saved.record.run;
  for (std::string* text :
       {&run.version, &run.log, &run.format, &run.sensor, &run.scanner_names[7], &run.preset}) {
    *text = draw.word();
  }
  run.options_json = "{\"a\":1}";
  run.parameters_json = "{\"b\":2}";
  run.findings_json = "[3]";
  run.num_damaged_records = draw.below(100);
  draw_sessions(draw, map);
  return saved;
}

std::string text_of(const SavedMap& saved) {
  Listing out;
  const Map& map = saved.map;
  list_record(out, saved.record);
  list_each(out, "scans", map.scans);
  out.add("keyframes", map.keyframes.size());
  for (const std::size_t keyframe : map.keyframes) out.add("keyframe", keyframe);
  list_each(out, "headings", map.headings);
  list_each(out, "frames", map.frames);
  list_each(out, "pieces", map.pieces);
  list_each(out, "closures", map.closures);
  list_each(out, "open_stretches", map.open_stretches);
  list_each(out, "undecided_turns", map.undecided_turns);
  list_reports(out, map);
  out.add("nodes", map.graph.T_map_node.size());
  for (const Pose2& pose : map.graph.T_map_node) out.add("T_map_node", pose);
  list_each(out, "constraints", map.graph.constraints);
  list_each(out, "heading measurements", map.graph.headings);
  list_each(out, "doubts", map.doubts);
  list_sessions(out, map);
  out.add("kept_scans", map.kept_scans.size());
  for (const KeptScan& kept : map.kept_scans) {
    out.add("index", kept.index);
    list(out, *kept.scan);
  }
  return out.text();
}

}  // namespace setsquare::testing

// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/pose_graph_g2o.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/io/bytes/line_reader.hpp"
#include "setsquare/io/bytes/shortest_number.hpp"
#include "setsquare/io/bytes/text_beginning.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"

namespace setsquare {
namespace {

/// Beyond this, arithmetic with information would overflow; no measurement is that certain.
constexpr double kMaxInformation = 1e60;
/// An eigenvalue may be negative by this share of the largest: rounding of the file's digits.
constexpr double kRounding = 1e-6;

template <typename Number>
void append(std::string& text, Number number) {
  text += ' ';
  append_shortest(text, number);
}

void append(std::string& text, const Pose2& pose) {
  append(text, pose.x_m);
  append(text, pose.y_m);
  append(text, pose.theta_rad);
}

/// Appends the upper triangle, row by row.
void append(std::string& text, const Eigen::Matrix3d& information) {
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) append(text, information(row, column));
  }
}

/// Information of a residual that is turned by the angle: R^T I R.
Eigen::Matrix3d turned(const Eigen::Matrix3d& information, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  Eigen::Matrix3d R;
  R << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  Eigen::Matrix3d result = R.transpose() * information * R;
  for (int k = 0; k < 3; ++k) result(k, k) = std::max(0.0, result(k, k));
  return 0.5 * (result + result.transpose());
}

void append_edges(std::string& text, const PoseGraph& graph, ConstraintKind kind) {
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind != kind) continue;
    text += "EDGE_SE2";
    append(text, constraint.from);
    append(text, constraint.to);
    append(text, constraint.T_from_to);
    append(text,
           turned(constraint.weight * constraint.information, constraint.T_from_to.theta_rad));
    text += '\n';
  }
}

/// Finite, not too large, positive semi-definite.
bool is_information(const Eigen::Matrix3d& information) {
  if (information.cwiseAbs().maxCoeff() > kMaxInformation) return false;
  const Eigen::Vector3d eigenvalues = symmetric_eigenvalues(information);
  return eigenvalues[0] >= -kRounding * eigenvalues[2];
}

/// A line's numbers, after its kind and ids.
struct PoseAndInformation {
  Pose2 pose;
  Eigen::Matrix3d information;
};

std::optional<PoseAndInformation> read_pose_and_information(TextScanner& text) {
  const auto pose = text.pose();
  if (!pose) return std::nullopt;
  PoseAndInformation read{*pose, Eigen::Matrix3d::Zero()};
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      const auto number = text.finite_number();
      if (!number) return std::nullopt;
      read.information(row, column) = read.information(column, row) = *number;
    }
  }
  if (!text.is_at_end() || !is_information(read.information)) return std::nullopt;
  return read;
}

/// The lines of a file, before ids become nodes.
class G2oLines {
 public:
  explicit G2oLines(std::string name) : name_(std::move(name)) {}

  void add(std::string_view line, std::uint64_t line_number) {
    TextScanner text(line);
    const auto kind = text.word();
    if (!kind || kind->front() == '#') return;
    if (*kind == "VERTEX_SE2") {
      require(add_vertex(text, line_number), line_number, "\"VERTEX_SE2 id x y theta\"");
    } else if (*kind == "EDGE_SE2") {
      require(add_edge(text, line_number),
              line_number,
              "\"EDGE_SE2 i j x y theta\" and the upper triangle of an information matrix");
    } else if (*kind == "EDGE_PRIOR_SE2") {
      require(add_prior(text, line_number),
              line_number,
              "\"EDGE_PRIOR_SE2 id x y theta\" and the upper triangle of an information matrix");
    } else if (*kind == "FIX") {
      require(text.count().has_value(), line_number, "\"FIX id\"");
    } else {
      ++num_passed_over_;
    }
  }

  [[nodiscard]] PoseGraphG2o finish() {
    if (vertices_.empty()) throw FormatError(name_, "", "no line of \"VERTEX_SE2 id x y theta\"");
    std::ranges::stable_sort(vertices_, {}, &Vertex::id);
    PoseGraphG2o read;
    read.num_passed_over = num_passed_over_;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      if (k > 0 && vertices_[k].id == vertices_[k - 1].id) {
        fail(vertices_[k].line_number, fmt::format("vertex {} again", vertices_[k].id));
      }
      read.graph.T_map_node.push_back(vertices_[k].T_map_node);
    }
    for (const Edge& edge : edges_) {
      Constraint constraint = edge.constraint;
      constraint.from = node_of(edge.from_id, edge.line_number);
      constraint.to = node_of(edge.to_id, edge.line_number);
      if (constraint.from == constraint.to) fail(edge.line_number, "an edge must join two nodes");
      const auto [low, high] = std::minmax(constraint.from, constraint.to);
      const bool is_step = high == low + 1;
      constraint.kind = is_step ? ConstraintKind::kOdometry : ConstraintKind::kLoopClosure;
      read.graph.constraints.push_back(constraint);
    }
    for (const Prior& prior : priors_) {
      HeadingMeasurement heading = prior.heading;
      heading.node = node_of(prior.id, prior.line_number);
      read.graph.headings.push_back(heading);
    }
    return read;
  }

 private:
  struct Vertex {
    std::uint32_t id = 0;
    Pose2 T_map_node;
    std::uint64_t line_number = 0;
  };
  struct Edge {
    std::uint32_t from_id = 0;
    std::uint32_t to_id = 0;
    Constraint constraint;
    std::uint64_t line_number = 0;
  };
  struct Prior {
    std::uint32_t id = 0;
    HeadingMeasurement heading;
    std::uint64_t line_number = 0;
  };

  [[noreturn]] void fail(std::uint64_t line_number, const std::string& reason) const {
    throw FormatError(name_, fmt::format("line {}", line_number), reason);
  }

  void require(bool is_read, std::uint64_t line_number, const std::string& expected) const {
    if (!is_read) fail(line_number, "expected " + expected);
  }

  bool add_vertex(TextScanner& text, std::uint64_t line_number) {
    const auto id = text.count();
    const auto pose = id ? text.pose() : std::nullopt;
    if (!pose || !text.is_at_end()) return false;
    vertices_.push_back({*id, *pose, line_number});
    return true;
  }

  bool add_edge(TextScanner& text, std::uint64_t line_number) {
    const auto from_id = text.count();
    const auto to_id = from_id ? text.count() : std::nullopt;
    const auto read = to_id ? read_pose_and_information(text) : std::nullopt;
    if (!read) return false;
    Constraint constraint;
    constraint.T_from_to = read->pose;
    constraint.information = turned(read->information, -read->pose.theta_rad);
    edges_.push_back({*from_id, *to_id, constraint, line_number});
    return true;
  }

  bool add_prior(TextScanner& text, std::uint64_t line_number) {
    const auto id = text.count();
    const auto read = id ? read_pose_and_information(text) : std::nullopt;
    if (!read) return false;
    const double information = std::max(0.0, read->information(2, 2));
    priors_.push_back({*id, {0, read->pose.theta_rad, information}, line_number});
    return true;
  }

  [[nodiscard]] std::size_t node_of(std::uint32_t id, std::uint64_t line_number) const {
    const auto found = std::ranges::lower_bound(vertices_, id, {}, &Vertex::id);
    if (found == vertices_.end() || found->id != id) {
      fail(line_number, fmt::format("there is no vertex {}", id));
    }
    return static_cast<std::size_t>(found - vertices_.begin());
  }

  std::string name_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Prior> priors_;
  std::uint64_t num_passed_over_ = 0;
};

}  // namespace

std::string g2o_from_pose_graph(const PoseGraph& graph) {
  std::string text;
  for (std::size_t node = 0; node < graph.T_map_node.size(); ++node) {
    text += "VERTEX_SE2";
    append(text, node);
    append(text, graph.T_map_node[node]);
    text += '\n';
  }
  if (!graph.T_map_node.empty()) text += "FIX 0\n";
  append_edges(text, graph, ConstraintKind::kOdometry);
  append_edges(text, graph, ConstraintKind::kLoopClosure);
  for (const HeadingMeasurement& heading : graph.headings) {
    const Pose2& pose = graph.T_map_node[heading.node];
    text += "EDGE_PRIOR_SE2";
    append(text, heading.node);
    append(text, Pose2{pose.x_m, pose.y_m, heading.heading_rad});
    text += " 0 0 0 0 0";
    append(text, heading.information_per_rad2);
    text += '\n';
  }
  return text;
}

PoseGraphG2o read_pose_graph_g2o(std::unique_ptr<ByteSource> source, const std::string& name) {
  InputBuffer input(unpack(std::move(source)));
  begin_text(input, name);
  LineReader lines(input);
  G2oLines content(name);
  while (const auto line = lines.next()) content.add(*line, lines.line_number());
  const std::string damage = input.source().damage();
  if (!damage.empty()) throw FormatError(name, "", damage);
  return content.finish();
}

PoseGraph read_pose_graph_g2o(const std::string& path) {
  return read_pose_graph_g2o(open_file_source(path), path).graph;
}

}  // namespace setsquare

// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A robot on Cyclone DDS, which shares no code with Setsquare: drives through an L-shaped room,
// publishes its scans, its mounting and its odometry, hears what live mapping finds, and asks its
// services. robot_peer DOMAIN NUM_SCANS PERIOD_MS [slam_toolbox] [say] prints what it heard, a
// line each. It asks slam_toolbox's services, too; says on /initialpose, twice, that it is where it
// is not.
#include <dds/dds.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "robot.h"

#define NUM_BEAMS 360
#define MAX_SCANS 5000
#define PI 3.14159265358979323846

typedef sensor_msgs_msg_dds__LaserScan_ LaserScan;
typedef tf2_msgs_msg_dds__TFMessage_ TfMessage;
typedef geometry_msgs_msg_dds__TransformStamped_ Transform;
typedef geometry_msgs_msg_dds__PoseWithCovarianceStamped_ Pose;
typedef nav_msgs_msg_dds__OccupancyGrid_ Grid;

static dds_entity_t participant;

static dds_entity_t checked(dds_entity_t entity, const char *what) {
  if (entity >= 0) return entity;
  fprintf(stderr, "%s: %s\n", what, dds_strretcode(-entity));
  exit(2);
}

static dds_qos_t *qos_of(bool is_reliable, bool is_transient_local, int depth) {
  dds_qos_t *qos = dds_create_qos();
  dds_qset_reliability(
      qos, is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_MSECS(100));
  dds_qset_durability(
      qos, is_transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  return qos;
}

static dds_entity_t topic(const dds_topic_descriptor_t *type, const char *name) {
  return checked(dds_create_topic(participant, type, name, NULL, NULL), name);
}

static dds_entity_t writer(const dds_topic_descriptor_t *type, const char *name, bool is_reliable,
                           bool is_latched, int depth) {
  return checked(dds_create_writer(participant, topic(type, name),
                                   qos_of(is_reliable, is_latched, depth), NULL), name);
}

static dds_entity_t reader(const dds_topic_descriptor_t *type, const char *name, bool is_latched,
                           int depth) {
  return checked(dds_create_reader(participant, topic(type, name), qos_of(true, is_latched, depth),
                                   NULL), name);
}

// --- The world ----------------------------------------------------------------------------------

static const double walls[][4] = {
    {0, 0, 8, 0},     {8, 0, 8, 5},     {8, 5, 3.5, 5}, {3.5, 5, 3.5, 9}, {3.5, 9, 0, 9},
    {0, 9, 0, 0},     {6.2, 0, 6.2, 1.3}, {6.2, 1.3, 8, 1.3}, {0, 6.1, 0.9, 6.1},
    {0.9, 6.1, 0.9, 7.0}, {0.9, 7.0, 0, 7.0}};

static double range_m(double x, double y, double angle) {
  double nearest = 1e9;
  for (size_t i = 0; i < sizeof walls / sizeof walls[0]; ++i) {
    const double wx = walls[i][2] - walls[i][0], wy = walls[i][3] - walls[i][1];
    const double dx = cos(angle), dy = sin(angle);
    const double det = wx * dy - wy * dx;
    if (fabs(det) < 1e-12) continue;
    const double tx = walls[i][0] - x, ty = walls[i][1] - y;
    const double range = (wx * ty - wy * tx) / det, share = (dx * ty - dy * tx) / det;
    if (range > 1e-9 && share >= 0 && share <= 1 && range < nearest) nearest = range;
  }
  return nearest;
}

/// Around in the room, a step of 4 cm or 2 degrees per scan.
static void pose_at(int k, double *x, double *y, double *theta) {
  static const double way[][2] = {{1, 1}, {5, 1.5}, {5.5, 3.5}, {2, 4}, {2, 8}, {2.5, 3}, {1, 1}};
  const int num = sizeof way / sizeof way[0];
  *x = way[0][0], *y = way[0][1], *theta = 0;
  for (int w = 1; k > 0; w = w % (num - 1) + 1) {
    const double dx = way[w][0] - *x, dy = way[w][1] - *y;
    const double turn = remainder(atan2(dy, dx) - *theta, 2 * PI);
    const int turns = (int)ceil(fabs(turn) / (2 * PI / 180)), steps = (int)ceil(hypot(dx, dy) / 0.04);
    const int t = k < turns ? k : turns;
    *theta += turns > 0 ? turn * t / turns : 0, k -= t;
    const int s = k < steps ? k : steps;
    *x += dx * s / steps, *y += dy * s / steps, k -= s;
  }
}

static double noise(void) { return 0.01 * (rand() / (double)RAND_MAX - 0.5); }

static builtin_interfaces_msg_dds__Time_ stamp_of(int64_t ns) {
  builtin_interfaces_msg_dds__Time_ time = {(int32_t)(ns / 1000000000), (uint32_t)(ns % 1000000000)};
  return time;
}

static Transform transform(int64_t ns, char *parent, char *child, double x, double y, double theta) {
  Transform made;
  memset(&made, 0, sizeof made);
  made.header.stamp = stamp_of(ns), made.header.frame_id = parent, made.child_frame_id = child;
  made.transform.translation.x = x, made.transform.translation.y = y;
  made.transform.rotation.z = sin(theta / 2), made.transform.rotation.w = cos(theta / 2);
  return made;
}

static void write_transform(dds_entity_t to, Transform *one) {
  TfMessage message;
  memset(&message, 0, sizeof message);
  message.transforms._length = message.transforms._maximum = 1, message.transforms._buffer = one;
  dds_write(to, &message);
}

// --- What is heard ------------------------------------------------------------------------------

static int64_t stamps[MAX_SCANS];
static int num_scans, num_tf, num_tf_with_stamp, num_poses, num_maps, num_diagnostics;
static double first_x, first_y, last_x, last_y, last_covariance;
static uint32_t map_width, map_height, num_free, num_occupied;

static bool is_stamp_of_scan(builtin_interfaces_msg_dds__Time_ time) {
  for (int i = 0; i < num_scans; ++i) {
    if (stamps[i] == time.sec * INT64_C(1000000000) + time.nanosec) return true;
  }
  return false;
}

static void see_grid(const Grid *grid) {
  map_width = grid->info.width, map_height = grid->info.height, num_free = num_occupied = 0;
  for (uint32_t i = 0; i < grid->data._length; ++i) {
    num_free += grid->data._buffer[i] == 0, num_occupied += grid->data._buffer[i] == 100;
  }
}

#define TAKE(reader, Type, one, ...)                                                  \
  do {                                                                                \
    void *taken[1] = {NULL};                                                          \
    dds_sample_info_t info[1];                                                        \
    while (dds_take(reader, taken, info, 1, 1) > 0) {                                 \
      const Type *one = taken[0];                                                     \
      if (info[0].valid_data) __VA_ARGS__                                             \
      dds_return_loan(reader, taken, 1);                                              \
      taken[0] = NULL;                                                                \
    }                                                                                 \
  } while (0)

static void hear(dds_entity_t tf, dds_entity_t pose, dds_entity_t map, dds_entity_t diagnostics) {
  TAKE(tf, TfMessage, heard, {
    for (uint32_t i = 0; i < heard->transforms._length; ++i) {
      const Transform *one = &heard->transforms._buffer[i];
      if (strcmp(one->header.frame_id, "map") || strcmp(one->child_frame_id, "odom")) continue;
      ++num_tf, num_tf_with_stamp += is_stamp_of_scan(one->header.stamp);
    }
  });
  TAKE(pose, Pose, heard, {
    last_x = heard->pose.pose.position.x, last_y = heard->pose.pose.position.y;
    if (num_poses++ == 0) first_x = last_x, first_y = last_y;
    last_covariance = heard->pose.covariance[0];
  });
  TAKE(map, Grid, heard, { ++num_maps, see_grid(heard); });
  TAKE(diagnostics, diagnostic_msgs_msg_dds__DiagnosticArray_, heard, {
    ++num_diagnostics;
    printf("diagnostic %d %s: %s\n", heard->status._buffer[0].level, heard->status._buffer[0].name,
           heard->status._buffer[0].message);
  });
}

/// Waits for a reply of a type that begins with who asked and the question's number.
#define ASK(service, Type, desc, request, one, ...)                                             \
  do {                                                                                          \
    dds_entity_t to = writer(&desc##_Request__desc, "rq" service "Request", true, false, 10);   \
    dds_entity_t from = reader(&desc##_Response__desc, "rr" service "Reply", false, 10);        \
    dds_publication_matched_status_t asked = {0};                                               \
    dds_subscription_matched_status_t answered = {0};                                           \
    for (int i = 0; i < 200 && !(asked.current_count && answered.current_count); ++i) {         \
      dds_sleepfor(DDS_MSECS(50));                                                              \
      dds_get_publication_matched_status(to, &asked);                                           \
      dds_get_subscription_matched_status(from, &answered);                                     \
    }                                                                                           \
    request.guid = 4711, request.seq = 3;                                                       \
    dds_write(to, &request);                                                                    \
    bool is_answered = false;                                                                   \
    for (int i = 0; i < 600 && !is_answered; ++i) {                                             \
      dds_sleepfor(DDS_MSECS(50));                                                              \
      TAKE(from, Type##_Response_, one, {                                                       \
        is_answered = one->guid == 4711 && one->seq == 3;                                       \
        __VA_ARGS__                                                                             \
      });                                                                                       \
    }                                                                                           \
    if (!is_answered) printf("%s unanswered\n", service);                                       \
  } while (0)

static void ask_all(bool has_slam_toolbox) {
  std_srvs_srv_dds__Trigger_Request_ save = {0};
  ASK("/setsquare/save_map", std_srvs_srv_dds__Trigger, std_srvs_srv_dds__Trigger, save, reply, {
    printf("save_map %d %s\n", reply->success, reply->message);
  });
  nav_msgs_srv_dds__GetMap_Request_ get = {0};
  ASK("/setsquare/get_map", nav_msgs_srv_dds__GetMap, nav_msgs_srv_dds__GetMap, get, reply, {
    see_grid(&reply->grid);
    printf("get_map %u %u %u %u\n", map_width, map_height, num_free, num_occupied);
  });
  std_srvs_srv_dds__SetBool_Request_ pause = {0};
  pause.data = true;
  ASK("/setsquare/pause", std_srvs_srv_dds__SetBool, std_srvs_srv_dds__SetBool, pause, reply, {
    printf("pause %d %s\n", reply->success, reply->message);
  });
  if (!has_slam_toolbox) return;
  slam_toolbox_srv_dds__SaveMap_Request_ named = {0};
  char name[] = "by_name";
  named.name.data = name;
  ASK("/slam_toolbox/save_map", slam_toolbox_srv_dds__SaveMap, slam_toolbox_srv_dds__SaveMap, named,
      reply, { printf("slam_toolbox save_map %d\n", reply->result); });
  char elsewhere[] = "../elsewhere";
  named.name.data = elsewhere;
  ASK("/slam_toolbox/save_map", slam_toolbox_srv_dds__SaveMap, slam_toolbox_srv_dds__SaveMap, named,
      reply, { printf("slam_toolbox save_map elsewhere %d\n", reply->result); });
}

static bool is_asked(int argc, char **argv, const char *word) {
  for (int i = 4; i < argc; ++i) {
    if (strcmp(argv[i], word) == 0) return true;
  }
  return false;
}

static void say_pose(void) {
  dds_entity_t said = writer(&geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc,
                             "rt/initialpose", true, false, 10);
  dds_publication_matched_status_t matched = {0};
  for (int i = 0; i < 200 && matched.current_count == 0; ++i) {
    dds_sleepfor(DDS_MSECS(50));
    dds_get_publication_matched_status(said, &matched);
  }
  printf("said to %u\n", matched.current_count);
  char map[] = "map";
  Pose pose;
  memset(&pose, 0, sizeof pose);
  pose.header.frame_id = map;
  pose.pose.pose.position.x = 1.5, pose.pose.pose.position.y = 6.0;
  pose.pose.pose.orientation.z = sin(0.5), pose.pose.pose.orientation.w = cos(0.5);
  dds_write(said, &pose), dds_write(said, &pose);
}

int main(int argc, char **argv) {
  if (argc < 4) return 2;
  const int num = atoi(argv[2]), period_ms = atoi(argv[3]);
  if (num > MAX_SCANS) return 2;
  participant = checked(dds_create_participant((dds_domainid_t)atoi(argv[1]), NULL, NULL), "domain");
  dds_entity_t scans = writer(&sensor_msgs_msg_dds__LaserScan__desc, "rt/scan", false, false, 5);
  dds_entity_t tf = writer(&tf2_msgs_msg_dds__TFMessage__desc, "rt/tf", true, false, 100);
  dds_entity_t fixed = writer(&tf2_msgs_msg_dds__TFMessage__desc, "rt/tf_static", true, true, 1);
  dds_entity_t heard_tf = reader(&tf2_msgs_msg_dds__TFMessage__desc, "rt/tf", false, 1000);
  dds_entity_t heard_pose = reader(&geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, "rt/pose",
                                   false, 100);
  dds_entity_t heard_map = reader(&nav_msgs_msg_dds__OccupancyGrid__desc, "rt/map", true, 1);
  dds_entity_t heard_diagnostics = reader(&diagnostic_msgs_msg_dds__DiagnosticArray__desc,
                                          "rt/diagnostics", false, 10);
  dds_publication_matched_status_t matched = {0};
  for (int i = 0; i < 400 && matched.current_count == 0; ++i) {
    dds_sleepfor(DDS_MSECS(50));
    dds_get_publication_matched_status(scans, &matched);
  }
  printf("matched %u\n", matched.current_count);
  dds_sleepfor(DDS_MSECS(500));  // the other way round, too
  if (is_asked(argc, argv, "say")) say_pose();

  char map_odom[] = "odom", base[] = "base_link", laser[] = "laser";
  const int64_t begin_ns = dds_time();
  Transform mounting = transform(begin_ns, base, laser, 0.1, 0, 0);
  write_transform(fixed, &mounting);
  static float ranges[NUM_BEAMS];
  double x = 0, y = 0, theta = 0;
  for (int k = 0; k < num; ++k) {
    pose_at(k, &x, &y, &theta);
    const int64_t ns = begin_ns + k * INT64_C(100000000);
    Transform odometry = transform(ns, map_odom, base, x, y, theta);
    write_transform(tf, &odometry);
    LaserScan scan;
    memset(&scan, 0, sizeof scan);
    scan.header.stamp = stamp_of(ns), scan.header.frame_id = laser;
    scan.angle_min = (float)-PI, scan.angle_increment = (float)(2 * PI / NUM_BEAMS);
    scan.angle_max = scan.angle_min + (NUM_BEAMS - 1) * scan.angle_increment;
    scan.range_min = 0.05F, scan.range_max = 30.0F;
    scan.ranges._length = scan.ranges._maximum = NUM_BEAMS, scan.ranges._buffer = ranges;
    for (int i = 0; i < NUM_BEAMS; ++i) {
      ranges[i] = (float)(range_m(x + 0.1 * cos(theta), y + 0.1 * sin(theta),
                                  theta - PI + i * 2 * PI / NUM_BEAMS) + noise());
    }
    stamps[num_scans++] = ns;
    dds_write(scans, &scan);
    dds_sleepfor(DDS_MSECS(period_ms));
    hear(heard_tf, heard_pose, heard_map, heard_diagnostics);
  }
  for (int i = 0; i < 60 && (num_poses < num || num_maps == 0); ++i) {
    dds_sleepfor(DDS_MSECS(100));
    hear(heard_tf, heard_pose, heard_map, heard_diagnostics);
  }
  printf("scans %d\ntf %d\ntf_with_stamp %d\nposes %d\nmaps %d\n", num_scans, num_tf,
         num_tf_with_stamp, num_poses, num_maps);
  // How far the robot is from where it began.
  printf("truth %.3f\npose %.3f\ncovariance %.6f\n", hypot(x - 1, y - 1), hypot(last_x - first_x, last_y - first_y),
         last_covariance);
  printf("map %u %u %u %u\n", map_width, map_height, num_free, num_occupied);
  // One who comes late gets the last map, too.
  dds_entity_t late = reader(&nav_msgs_msg_dds__OccupancyGrid__desc, "rt/map", true, 1);
  int num_late = 0;
  for (int i = 0; i < 100 && num_late == 0; ++i) {
    dds_sleepfor(DDS_MSECS(50));
    TAKE(late, Grid, heard, { ++num_late, see_grid(heard); });
  }
  printf("late_maps %d\n", num_late);
  ask_all(is_asked(argc, argv, "slam_toolbox"));
  hear(heard_tf, heard_pose, heard_map, heard_diagnostics);
  printf("diagnostics %d\n", num_diagnostics);
  dds_delete(participant);
  return 0;
}

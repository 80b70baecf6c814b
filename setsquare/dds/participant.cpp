// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Fast DDS 2.9 (Debian 12). How ROS 2 names and fills what DDS has: design.ros2.org and the sources
// of rmw_fastrtps, rmw_cyclonedds and rmw_dds_common (docs/live.md).
#include "setsquare/dds/participant.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/dds/raw_cdr_type.hpp"
#include "setsquare/io/ros/cdr_writer.hpp"

namespace setsquare::dds {
namespace {

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::size_t kHeaderBytes = 4;

std::vector<rtps::octet> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

template <typename Entity>
rtps::GUID_t guid_of(const Entity& entity) {
  return entity.guid();
}

/// The bytes of a GUID as they are sent.
std::string gid_of(const rtps::GUID_t& guid) {
  std::string gid(reinterpret_cast<const char*>(guid.guidPrefix.value), 12);
  gid.append(reinterpret_cast<const char*>(guid.entityId.value), 4);
  return gid;
}

/// FNV-1a: to tell writers apart.
std::uint64_t hash_of(const rtps::GUID_t& guid) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : gid_of(guid)) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  }
  return hash;
}

/// Of writers and of readers alike: the names of their policies are the same.
template <typename Qos>
void apply(const TopicQos& wanted, std::string_view type_hash, Qos& qos) {
  qos.reliability().kind =
      wanted.is_reliable ? fast::RELIABLE_RELIABILITY_QOS : fast::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = wanted.is_transient_local ? fast::TRANSIENT_LOCAL_DURABILITY_QOS
                                                    : fast::VOLATILE_DURABILITY_QOS;
  qos.history().kind = fast::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = wanted.depth;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  if (!type_hash.empty()) {
    qos.user_data().data_vec(bytes_of("typehash=" + std::string(type_hash) + ";"));
  }
}

fast::DomainParticipantQos participant_qos(const ParticipantOptions& options) {
  fast::DomainParticipantQos qos;
  qos.name(options.node_name);
  qos.user_data().data_vec(bytes_of("enclave=/;"));
  if (!options.is_local) return qos;
  // Sockets of the loopback device alone. Nodes that were told to stay local do not hear a
  // multicast: each of their ports is asked.
  constexpr std::uint32_t kNumPeers = 32;
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  udp->maxInitialPeersRange = kNumPeers;
  // A map comes in hundreds of pieces, scans of several scanners at once.
  constexpr std::uint32_t kSocketBytes = 4U << 20U;
  udp->sendBufferSize = kSocketBytes;
  udp->receiveBufferSize = kSocketBytes;
  qos.transport().user_transports.push_back(udp);
  rtps::Locator_t peer;
  peer.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(peer, "127.0.0.1");
  qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  rtps::Locator_t multicast;
  multicast.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(multicast, "239.255.0.1");
  qos.wire_protocol().builtin.initialPeersList.push_back(multicast);
  return qos;
}

}  // namespace

// Not in the anonymous namespace: Participant's parts hold them.

class WriterPublisher final : public Publisher {
 public:
  explicit WriterPublisher(fast::DataWriter* writer) : writer_(writer) {}

  void publish(std::string_view cdr) override {
    std::string message(cdr);
    writer_->write(&message);
  }
  void publish(std::string_view cdr, rtps::WriteParams& params) {
    std::string message(cdr);
    writer_->write(&message, params);
  }
  [[nodiscard]] int num_matched() const override {
    fast::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }
  [[nodiscard]] const fast::DataWriter* writer() const { return writer_; }

 private:
  fast::DataWriter* writer_;
};

/// Takes what comes and gives it on.
class Taking final : public fast::DataReaderListener {
 public:
  using OnSample = std::function<void(std::string& message, const fast::SampleInfo& info)>;

  Taking(OnSample on_sample, std::atomic<std::uint64_t>& num_refused)
      : on_sample_(std::move(on_sample)), num_refused_(num_refused) {}

  void on_data_available(fast::DataReader* reader) override {
    std::string message;
    fast::SampleInfo info;
    while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      const bool is_own =
          info.sample_identity.writer_guid().guidPrefix == guid_of(*reader).guidPrefix;
      if (is_own) continue;
      if (message.size() < kHeaderBytes) {
        ++num_refused_;
        continue;
      }
      on_sample_(message, info);
    }
  }

 private:
  OnSample on_sample_;
  std::atomic<std::uint64_t>& num_refused_;
};

namespace {

/// rmw_cyclonedds puts who asks, and the question's number, before a request and its reply.
constexpr std::size_t kCycloneHeaderBytes = 16;

bool is_of_cyclone(const rtps::GUID_t& guid) {
  return guid.guidPrefix.value[0] == 0x01 && guid.guidPrefix.value[1] == 0x10;
}

}  // namespace

std::string dds_type_name(const std::string& ros_type, const std::string& suffix) {
  const std::size_t package = ros_type.find('/');
  const std::size_t name = ros_type.rfind('/');
  if (package == std::string::npos || name == package) {
    throw ParameterError("type", "'" + ros_type + "' is no package/msg/Name");
  }
  return ros_type.substr(0, package) + "::" + ros_type.substr(package + 1, name - package - 1) +
         "::dds_::" + ros_type.substr(name + 1) + suffix + "_";
}

class Participant::Parts {
 public:
  explicit Parts(const ParticipantOptions& options) : node_name_(options.node_name) {
    constexpr int kMaxDomain = 232;  // Ports end there.
    if (options.domain < 0 || options.domain > kMaxDomain) {
      throw ParameterError("domain", "must be from 0 to 232");
    }
    participant_ = fast::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<fast::DomainId_t>(options.domain), participant_qos(options));
    if (participant_ == nullptr) {
      throw FileError("DDS domain " + std::to_string(options.domain), "cannot be joined");
    }
    publisher_ = participant_->create_publisher(fast::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT);
    node_info_ = std::make_unique<WriterPublisher>(
        make_writer("ros_discovery_info",
                    "rmw_dds_common/msg/ParticipantEntitiesInfo",
                    dds_type_name("rmw_dds_common/msg/ParticipantEntitiesInfo"),
                    kMapQos));
    answering_ = std::thread([this] { answer_until_end(); });
  }
  ~Parts() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    has_answers_.notify_one();
    answering_.join();
    for (fast::DataReader* reader : readers_) reader->set_listener(nullptr);
    participant_->delete_contained_entities();
    fast::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  std::shared_ptr<WriterPublisher> advertise(const std::string& topic,
                                             const std::string& ros_type,
                                             const std::string& type,
                                             const TopicQos& qos) {
    auto publisher = std::make_shared<WriterPublisher>(make_writer(topic, ros_type, type, qos));
    {
      const std::lock_guard lock(mutex_);
      writer_gids_.push_back(gid_of(guid_of(*publisher->writer())));
    }
    tell_node();
    return publisher;
  }

  void subscribe(const std::string& topic,
                 const std::string& ros_type,
                 const std::string& type,
                 const TopicQos& qos,
                 Taking::OnSample on_sample) {
    auto taking = std::make_unique<Taking>(std::move(on_sample), num_refused_);
    fast::DataReaderQos reader_qos = fast::DATAREADER_QOS_DEFAULT;
    apply(qos, type_hash(ros_type), reader_qos);
    fast::DataReader* reader =
        subscriber_->create_datareader(make_topic(topic, type), reader_qos, taking.get());
    if (reader == nullptr) throw FileError(topic, "cannot be subscribed to");
    {
      const std::lock_guard lock(mutex_);
      readers_.push_back(reader);
      listeners_.push_back(std::move(taking));
      reader_gids_.push_back(gid_of(guid_of(*reader)));
    }
    tell_node();
  }

  void serve(const std::string& service, const std::string& ros_type, OnRequest on_request) {
    const TopicQos qos{.is_reliable = true, .depth = 10};
    const auto replies =
        advertise("rr" + service + "Reply", ros_type, dds_type_name(ros_type, "_Response"), qos);
    subscribe("rq" + service + "Request",
              ros_type,
              dds_type_name(ros_type, "_Request"),
              qos,
              [replies, on_request = std::move(on_request), this](const std::string& request,
                                                                  const fast::SampleInfo& info) {
                reply(request, info, on_request, *replies);
              });
  }

  [[nodiscard]] std::uint64_t num_refused() const { return num_refused_; }

 private:
  fast::Topic* make_topic(const std::string& topic, const std::string& type) {
    const fast::TypeSupport support(new RawCdrType(type));
    if (!participant_->find_type(type)) support.register_type(participant_);
    if (auto* known = dynamic_cast<fast::Topic*>(participant_->lookup_topicdescription(topic))) {
      return known;
    }
    fast::Topic* made = participant_->create_topic(topic, type, fast::TOPIC_QOS_DEFAULT);
    if (made == nullptr) throw FileError(topic, "this topic cannot be made");
    return made;
  }

  fast::DataWriter* make_writer(const std::string& topic,
                                const std::string& ros_type,
                                const std::string& type,
                                const TopicQos& qos) {
    fast::DataWriterQos writer_qos = fast::DATAWRITER_QOS_DEFAULT;
    apply(qos, type_hash(ros_type), writer_qos);
    // Large messages are sent by a thread of the library's.
    writer_qos.publish_mode().kind = fast::ASYNCHRONOUS_PUBLISH_MODE;
    fast::DataWriter* writer = publisher_->create_datawriter(make_topic(topic, type), writer_qos);
    if (writer == nullptr) throw FileError(topic, "cannot be published");
    return writer;
  }

  /// Which reads and writes are this node's: `ros2 node list` is made of it.
  void tell_node() {
    const std::lock_guard lock(mutex_);
    ros::CdrWriter cdr;
    const auto write_gid = [&](const std::string& gid) {
      for (const char byte : gid) cdr.write(byte);
    };
    const auto write_gids = [&](const std::vector<std::string>& gids) {
      cdr.write_count(gids.size());
      for (const std::string& gid : gids) write_gid(gid);
    };
    write_gid(gid_of(guid_of(*participant_)));
    cdr.write_count(1);
    cdr.write_text("/");
    cdr.write_text(node_name_);
    write_gids(reader_gids_);
    write_gids(writer_gids_);
    node_info_->publish(cdr.message());
  }

  void reply(const std::string& request,
             const fast::SampleInfo& info,
             const OnRequest& on_request,
             WriterPublisher& replies) {
    const bool has_cyclone_header = is_of_cyclone(info.sample_identity.writer_guid());
    const std::size_t num_before = kHeaderBytes + (has_cyclone_header ? kCycloneHeaderBytes : 0);
    if (request.size() < num_before) {
      ++num_refused_;
      return;
    }
    std::string answer(kHeaderBytes, '\0');
    answer[1] = 1;  // Little-endian, as all that we write.
    if (has_cyclone_header) answer.append(request, kHeaderBytes, kCycloneHeaderBytes);
    answer += on_request(std::string_view(request).substr(num_before));
    rtps::WriteParams params;
    rtps::SampleIdentity asked = info.sample_identity;
    const rtps::GUID_t& reader = info.related_sample_identity.writer_guid();
    if (reader != rtps::GUID_t::unknown()) asked.writer_guid() = reader;
    params.related_sample_identity() = asked;
    replies.publish(answer, params);
  }

  /// Answers wait for each other, but nothing that comes waits for them.
  void enqueue(std::function<void()> answer) {
    constexpr std::size_t kMaxWaiting = 64;
    {
      const std::lock_guard lock(mutex_);
      if (answers_.size() >= kMaxWaiting) {
        ++num_refused_;
        return;
      }
      answers_.push_back(std::move(answer));
    }
    has_answers_.notify_one();
  }

  void answer_until_end() {
    std::unique_lock lock(mutex_);
    for (;;) {
      has_answers_.wait(lock, [this] { return is_ending_ || !answers_.empty(); });
      if (is_ending_) return;
      const std::function<void()> answer = std::move(answers_.front());
      answers_.pop_front();
      lock.unlock();
      answer();
      lock.lock();
    }
  }

  const std::string node_name_;
  fast::DomainParticipant* participant_ = nullptr;
  fast::Publisher* publisher_ = nullptr;
  fast::Subscriber* subscriber_ = nullptr;
  std::unique_ptr<WriterPublisher> node_info_;
  std::atomic<std::uint64_t> num_refused_ = 0;

  std::mutex mutex_;  ///< All below.
  std::vector<fast::DataReader*> readers_;
  std::vector<std::unique_ptr<Taking>> listeners_;
  std::vector<std::string> reader_gids_;
  std::vector<std::string> writer_gids_;
  std::condition_variable has_answers_;
  std::deque<std::function<void()>> answers_;
  bool is_ending_ = false;

  std::thread answering_;
};

Participant::Participant(const ParticipantOptions& options)
    : parts_(std::make_unique<Parts>(options)) {}
Participant::~Participant() = default;

std::shared_ptr<Publisher> Participant::advertise(const std::string& topic,
                                                  const std::string& type,
                                                  const TopicQos& qos) {
  return parts_->advertise("rt" + topic, type, dds_type_name(type), qos);
}

void Participant::subscribe(const std::string& topic,
                            const std::string& type,
                            const TopicQos& qos,
                            OnMessage on_message) {
  parts_->subscribe("rt" + topic,
                    type,
                    dds_type_name(type),
                    qos,
                    [on_message = std::move(on_message)](const std::string& message,
                                                         const fast::SampleInfo& info) {
                      on_message(message, hash_of(info.sample_identity.writer_guid()));
                    });
}

void Participant::serve(const std::string& service, const std::string& type, OnRequest on_request) {
  parts_->serve(service, type, std::move(on_request));
}

std::uint64_t Participant::num_refused() const { return parts_->num_refused(); }

}  // namespace setsquare::dds

// Rows 19 and 34 without a clock: turns by cost, simulated to the microsecond.
#include "frame/turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "common/camera_model.h"
#include "faults/figure.h"
#include "net/admission.h"

namespace amalgam::test {
namespace {

using frame::Turns;
using Seconds = Turns::Seconds;
using Time = Turns::Time;

struct Client {
  double period = 0.0, cost = 0.0;  // seconds
  std::size_t pixels = 640 * 480;
  int sent = 0, served = 0, in_time = 0;
  Time next{}, arrived{};
};

Time at(double seconds) {
  return Time() + std::chrono::duration_cast<Time::duration>(Seconds(3600.0 + seconds));
}

// The clients' frames arrive by their periods; a waiting frame is replaced by a newer one; one is
// rendered at a time. In time is what is done within a period of its arrival, or of its own cost.
void simulate(Turns& turns, std::map<Turns::Id, Client>& clients, double seconds) {
  double offset = 0.0;
  for (auto& [id, client] : clients) {
    turns.open(id, client.pixels);
    client.next = at(offset += 0.0013);
  }
  Time now = at(0.0);
  const auto arrive = [&](Time until) {
    for (auto& [id, client] : clients) {
      for (; client.next <= until;
           client.next += std::chrono::duration_cast<Time::duration>(Seconds(client.period))) {
        turns.submitted(id, client.next);
        client.arrived = client.next;
        ++client.sent;
      }
    }
  };
  while (now < at(seconds)) {
    arrive(now);
    // The renderer's thread sleeps unless a turn is ready, until one will be.
    const bool ready = turns.any_ready(now);
    const auto turn = turns.next(now);
    ASSERT_EQ(ready, turn.has_value());
    if (!turn) {
      Time next = clients.begin()->second.next;
      for (const auto& [id, client] : clients) next = std::min(next, client.next);
      if (const auto until = turns.withheld_until(now)) {
        ASSERT_GT(*until, now);
        next = std::min(next, *until);
      }
      now = next;
      continue;
    }
    Client& client = clients.at(*turn);
    const Time arrived = client.arrived;
    const Time end = now + std::chrono::duration_cast<Time::duration>(Seconds(client.cost));
    arrive(end);
    now = end;
    turns.served(*turn, Seconds(client.cost), now);
    ++client.served;
    const double allowed = std::max(client.period, client.cost) + client.cost;
    if (Seconds(end - arrived).count() <= allowed) ++client.in_time;
  }
}

double served_share(const Client& client) {
  return static_cast<double>(client.served) / client.sent;
}

TEST(Turns, OneHeavyClientCostsLightOnesAFifthAtMost) {
  for (const double heavy_cost : {0.3, 0.6, 1.0, 2.5}) {
    Turns turns;
    std::map<Turns::Id, Client> clients;
    for (Turns::Id id = 1; id <= 3; ++id) clients[id] = {.period = 0.25, .cost = 0.02};
    clients[4] = {.period = 0.2, .cost = heavy_cost, .pixels = 2048 * 2048};
    simulate(turns, clients, 120.0);
    double worst = 1.0;
    for (Turns::Id id = 1; id <= 3; ++id) worst = std::min(worst, served_share(clients[id]));
    print_figure("34", "beside frames of " + std::to_string(heavy_cost) + " s light clients lose",
                 100.0 * (1.0 - worst), "%", "<= 20 %");
    EXPECT_GE(worst, 0.8) << heavy_cost;
    EXPECT_GE(clients[4].served, 2);  // and it is served too
  }
}

// Who falls silent is not waited for.
TEST(Turns, AWithheldTurnComesWhenTheOthersFallSilent) {
  Turns turns;
  turns.open(1, 640 * 480);
  turns.open(2, 2048 * 2048);
  turns.submitted(1, at(0.0));
  turns.submitted(1, at(0.2));
  EXPECT_EQ(turns.next(at(0.2)), 1u);
  turns.served(1, Seconds(0.02), at(0.22));
  turns.submitted(2, at(0.3));
  EXPECT_EQ(turns.next(at(0.3)), 2u);
  turns.submitted(1, at(10.2));
  turns.served(2, Seconds(10.0), at(10.3));
  EXPECT_EQ(turns.next(at(10.3)), 1u);
  turns.served(1, Seconds(0.02), at(10.32));
  turns.submitted(2, at(10.4));
  EXPECT_EQ(turns.next(at(10.4)), std::nullopt) << "a fifth of the time, because of the other";
  EXPECT_EQ(turns.withheld_until(at(10.4)), at(12.2)) << "not in 40 s: by then it does not count";
  EXPECT_EQ(turns.next(at(12.2)), 2u);
}

// Long turns that were withheld must not turn back the others' time: who comes later would be owed
// all of it.
TEST(Turns, WhoComesLateIsOwedNothing) {
  Turns turns;
  std::map<Turns::Id, Client> clients;
  for (Turns::Id id = 1; id <= 3; ++id) clients[id] = {.period = 0.25, .cost = 0.08};
  clients[4] = {.period = 0.2, .cost = 1.0, .pixels = 2048 * 2048};
  simulate(turns, clients, 600.0);
  // Two that send all the time: one has been there, one is new. Neither comes first for long.
  turns.close(4);
  turns.close(3);
  turns.close(2);
  turns.open(5, 640 * 480);
  const Time begin = at(700.0);
  Time now = begin;
  std::map<Turns::Id, int> served;
  for (int i = 0; i < 100; ++i) {
    turns.submitted(1, now);
    turns.submitted(5, now);
    const auto turn = turns.next(now);
    ASSERT_TRUE(turn);
    ++served[*turn];
    now += std::chrono::milliseconds(80);
    turns.served(*turn, Seconds(0.08), now);
  }
  EXPECT_NEAR(served[1], served[5], 20);
}

TEST(Turns, TimeIsSharedByCostAndNotByFrame) {
  Turns turns;
  std::map<Turns::Id, Client> clients;
  clients[1] = {.period = 0.001, .cost = 0.08};
  clients[2] = {.period = 0.001, .cost = 0.01};
  simulate(turns, clients, 60.0);
  const double ratio = clients[1].served * 0.08 / (clients[2].served * 0.01);
  print_figure("34", "time of frames eight times as long against the others'", ratio, "",
               "1: by cost");
  EXPECT_NEAR(ratio, 1.0, 0.1);
}

TEST(Turns, EqualsGoRound) {
  Turns turns;
  std::map<Turns::Id, Client> clients;
  for (Turns::Id id = 1; id <= 8; ++id) clients[id] = {.period = 0.01, .cost = 0.02};
  simulate(turns, clients, 30.0);
  for (const auto& [id, client] : clients) EXPECT_NEAR(client.served, clients[1].served, 2) << id;
}

// A client that sends 240 frames a second must not make everybody else's turn a long one.
TEST(Turns, WhoSendsFastSlowsNobodyDown) {
  Turns turns;
  std::map<Turns::Id, Client> clients;
  clients[1] = {.period = 1.0 / 240.0, .cost = 0.005};
  clients[2] = {.period = 0.2, .cost = 0.05};
  simulate(turns, clients, 60.0);
  EXPECT_GE(served_share(clients[2]), 0.95);
}

// With twice the load that there is time for, those that are admitted are served in time.
TEST(Turns, AdmittedSessionsStayInTime) {
  Turns turns;
  net::Admission admission({.load = 0.85, .memory = 0});
  const common::CameraModel camera = common::default_camera(640, 480);
  std::map<Turns::Id, Client> admitted;
  int busy = 0;
  turns.assume_seconds_per_pixel(0.025 / (640.0 * 480.0));
  // 25 ms at 5 frames a second is an eighth; sixteen ask for twice the renderer.
  for (Turns::Id id = 1; id <= 16; ++id) {
    const Time now = at(0.0);
    const frame::ServiceLoad load{.demand = turns.demand(now),
                                  .seconds_per_pixel = turns.seconds_per_pixel(),
                                  .frames_per_second = turns.mean_rate(now)};
    if (admission.admit(camera, load)) {
      ++busy;
      continue;
    }
    turns.open(id, 640 * 480);
    admitted[id] = {.period = 0.2, .cost = 0.025};
  }
  for (const auto& [id, client] : admitted) turns.close(id);
  simulate(turns, admitted, 60.0);
  double sent = 0.0, in_time = 0.0;
  for (const auto& [id, client] : admitted) {
    sent += client.sent;
    in_time += client.in_time;
  }
  print_figure("19", "of 16 sessions admitted", static_cast<double>(admitted.size()), "",
               "85 % of the time, 6");
  print_figure("19", "their frames in time", 100.0 * in_time / sent, "%", ">= 95 %");
  EXPECT_EQ(admitted.size(), 6u);
  EXPECT_EQ(busy, 10);
  EXPECT_GE(in_time / sent, 0.95);
}

TEST(Turns, TheFirstSessionIsAlwaysAdmitted) {
  net::Admission admission({.load = 0.85, .memory = 0});
  const common::CameraModel camera = common::default_camera(2048, 2048);
  const frame::ServiceLoad slow{.seconds_per_pixel = 1e-6, .frames_per_second = 5.0};
  EXPECT_FALSE(admission.admit(camera, slow));
  const auto second = admission.admit(camera, slow);
  ASSERT_TRUE(second);
  EXPECT_GE(second->retry_after, protocol::kRetryAfter);
  admission.leave(camera);
  EXPECT_FALSE(admission.admit(camera, slow));
}

}  // namespace
}  // namespace amalgam::test

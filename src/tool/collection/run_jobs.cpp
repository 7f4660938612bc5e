// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_jobs.h"

#ifdef CANONICAL_POSE_WITH_MPI
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/string.hpp>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <list>
#include <optional>
#include <string>
#include <thread>

namespace Canonical_pose_tool {

namespace {

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

} // namespace

void run_jobs(const std::vector<Shape_job>& jobs, const std::size_t number_of_workers,
              const Job_ended& ended)
{
  struct Running
  {
    explicit Running(const Shape_job& started)
      : job(&started), process(started.arguments, started.limits)
    {}

    const Shape_job* job;
    Child_process process;
  };
  std::list<Running> running;
  for(auto next = jobs.begin(); next != jobs.end() || !running.empty();)
  {
    while(next != jobs.end() && running.size() < number_of_workers)
    {
      running.emplace_back(*next++);
    }
    bool is_idle = true;
    for(auto worker = running.begin(); worker != running.end();)
      if(const auto ending = worker->process.ending())
      {
        const Shape_job& job = *worker->job;
        worker = running.erase(worker);
        ended(job, *ending);
        is_idle = false;
      }
      else
        ++worker;
    if(is_idle)
      pause();
  }
}

#ifdef CANONICAL_POSE_WITH_MPI

namespace {

namespace mpi = boost::mpi;

// Messages to a worker: a job, or an empty text at the end. From a worker: how a job ended, or an
// empty text at the start.
constexpr int TAG = 1;

bool is_started_by_mpi()
{
  for(const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if(std::getenv(name))
      return true;
  return false;
}

Child_process::Ending run(const std::string& message)
{
  std::vector<std::string> arguments;
  Child_process::Limits limits;
  from_text(message, arguments, limits);
  Child_process process(arguments, limits);
  for(;;)
  {
    if(const auto ending = process.ending())
      return *ending;
    pause();
  }
}

// Waits for a message without using the processor.
mpi::status await(const mpi::communicator& world, const int source)
{
  for(;;)
  {
    if(const auto status = world.iprobe(source, TAG))
      return *status;
    pause();
  }
}

void work(const mpi::communicator& world)
{
  world.send(0, TAG, std::string());
  for(std::string message;;)
  {
    await(world, 0);
    world.recv(0, TAG, message);
    if(message.empty())
      return;
    world.send(0, TAG, to_text(run(message)));
  }
}

// The first rank's view of the others.
class Ranks
{
public:
  explicit Ranks(const mpi::communicator& world)
    : m_world(world), m_states(static_cast<std::size_t>(world.size()), State::STARTING)
  {}

  void run(const std::vector<Shape_job>& jobs, const Job_ended& ended)
  {
    std::vector<const Shape_job*> job_of(m_states.size(), nullptr);
    auto next = jobs.begin();
    const auto give_job = [&](const std::size_t rank) {
      job_of[rank] = next != jobs.end() ? &*next++ : nullptr;
      if(job_of[rank])
        m_world.send(static_cast<int>(rank), TAG,
                     to_text(job_of[rank]->arguments, job_of[rank]->limits));
      m_states[rank] = job_of[rank] ? State::RUNNING : State::WAITING;
    };
    for(std::size_t rank = 1; rank < m_states.size(); ++rank)
      if(m_states[rank] == State::WAITING)
        give_job(rank);
    while(next != jobs.end() || is_one_running())
    {
      const auto rank = static_cast<std::size_t>(await(m_world, mpi::any_source).source());
      std::string message;
      m_world.recv(static_cast<int>(rank), TAG, message);
      const Shape_job* const done = job_of[rank];
      give_job(rank); // before the row is written, so that the worker does not wait
      if(done)
        ended(*done, ending_from_text(message));
    }
  }

  bool is_one_running() const
  {
    return std::find(m_states.begin(), m_states.end(), State::RUNNING) != m_states.end();
  }

  // Lets the others end; none of them may be running a job.
  void dismiss()
  {
    for(int rank = 1; rank < m_world.size(); ++rank)
    {
      std::string message;
      if(m_states[static_cast<std::size_t>(rank)] == State::STARTING)
        m_world.recv(rank, TAG, message);
      m_world.send(rank, TAG, std::string());
    }
  }

private:
  enum class State { STARTING, WAITING, RUNNING };

  const mpi::communicator& m_world;
  std::vector<State> m_states;
};

} // namespace

void with_mpi(const std::function<void(const Run_jobs&)>& on_first_rank)
{
  if(!is_started_by_mpi())
    return on_first_rank(Run_jobs());
  // The environment must not end by an exception, or MPI kills all ranks.
  std::exception_ptr failure;
  {
    const mpi::environment environment;
    const mpi::communicator world;
    Ranks ranks(world);
    try
    {
      if(world.rank() != 0)
        work(world);
      else
        on_first_rank(world.size() == 1 ? Run_jobs()
                                        : [&](const std::vector<Shape_job>& jobs,
                                              const Job_ended& ended) { ranks.run(jobs, ended); });
    }
    catch(const std::exception& error)
    {
      failure = std::current_exception();
      if(world.rank() != 0 || ranks.is_one_running())
      {
        std::cerr << "canonical-pose: " << error.what() << '\n';
        mpi::environment::abort(EXIT_FAILURE);
      }
    }
    if(world.rank() == 0)
      ranks.dismiss();
  }
  if(failure)
    std::rethrow_exception(failure);
}

#else

void with_mpi(const std::function<void(const Run_jobs&)>& on_first_rank)
{
  on_first_rank(Run_jobs());
}

#endif

} // namespace Canonical_pose_tool

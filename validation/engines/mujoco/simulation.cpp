// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/mujoco/simulation.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "validation/engines/mujoco/model_text.h"

namespace stiction_mujoco {

namespace {

using Eigen::Map, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;
using RowMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using ConstVector = Map<const Vector3d>;

// Of w, x, y, z.
Quaterniond rotation_of(const double* q) { return {q[0], q[1], q[2], q[3]}; }

Model compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const char* const name = "problem.xml";
  if (mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size())) != 0) {
    throw std::runtime_error("MuJoCo has no room for the model's text");
  }
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], text.data(), text.size());
  char words[1000] = "";
  Model model(mj_loadXML(name, files.get(), words, sizeof words));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + words);
  return model;
}

}  // namespace

Simulation::Simulation(const stiction_problem& problem) : problem_(problem) {
  model_ = compile(model_text(problem, read_parameters(problem)));
  data_.reset(mj_makeData(model_.get()));
  for (std::size_t b = 0; b < problem.body_count; ++b) {
    const stiction_body& body = problem.bodies[b];
    std::copy_n(body.position, 3, data_->qpos + 7 * b);
    std::copy_n(body.rotation, 4, data_->qpos + 7 * b + 3);
    std::copy_n(body.velocity, 3, data_->qvel + 6 * b);
    Map<Vector3d>(data_->qvel + 6 * b + 3) =  // in the body's frame
        rotation_of(body.rotation).conjugate() * ConstVector(body.angular_velocity);
  }
}

void Simulation::advance(std::uint64_t steps) {
  for (; steps > 0; --steps) {
    stiction_at(&problem_.gravity, data_->time, model_->opt.gravity);
    find_contacts();
    apply_loads();
    mj_step2(model_.get(), data_.get());
    refuse_divergence();
  }
}

// MuJoCo leaves out contacts for which it has no room: then there is to be more.
void Simulation::find_contacts() {
  for (;;) {
    mj_step1(model_.get(), data_.get());
    const bool contacts_full = data_->warning[mjWARN_CONTACTFULL].number > 0;
    const bool rows_full = data_->warning[mjWARN_CNSTRFULL].number > 0;
    if (!contacts_full && !rows_full) return;
    const auto more = [](int& room) { room += room / 2; };  // its memory is below 2 GB
    if (contacts_full) more(model_->nconmax);
    if (rows_full) {
      more(model_->njmax);
      more(model_->nstack);
    }
    Data roomier(mj_makeData(model_.get()));
    roomier->time = data_->time;
    std::copy_n(data_->qpos, model_->nq, roomier->qpos);
    std::copy_n(data_->qvel, model_->nv, roomier->qvel);
    std::copy_n(data_->qacc_warmstart, model_->nv, roomier->qacc_warmstart);
    data_ = std::move(roomier);
  }
}

void Simulation::apply_loads() {
  const double drag = stiction_drag(&problem_, data_->time);
  for (std::size_t b = 0; b < problem_.body_count; ++b) {
    double* const load = data_->xfrc_applied + 6 * (b + 1);
    std::fill_n(load, 6, 0.0);
    if (stiction_has_loads(&problem_, b)) {
      stiction_load(&problem_, b, data_->time, data_->qpos + 7 * b, load, load + 3);
    }
    if (drag > 0.0) {
      Map<Vector3d>(load) -= problem_.bodies[b].mass * drag * ConstVector(data_->qvel + 6 * b);
    }
  }
}

// MuJoCo starts again from the model's initial state when a number is none or beyond 1e10.
void Simulation::refuse_divergence() const {
  for (const int which : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data_->warning[which].number > 0) {
      throw std::runtime_error("MuJoCo diverged before " + std::to_string(data_->time) + " s");
    }
  }
}

void Simulation::body(std::size_t index, stiction_body_state& state) const {
  const double* const q = data_->qpos + 7 * index;
  const double* const v = data_->qvel + 6 * index;
  std::copy_n(q, 3, state.position);
  std::copy_n(q + 3, 4, state.rotation);
  std::copy_n(v, 3, state.velocity);
  Map<Vector3d>(state.angular_velocity) = rotation_of(q + 3) * ConstVector(v + 3);
}

std::size_t Simulation::contacts(stiction_contact* contacts, std::size_t room) const {
  std::size_t count = 0;
  for (int k = 0; k < data_->ncon; ++k) {
    if (data_->contact[k].efc_address < 0) continue;
    if (count < room) contacts[count] = contact(k);
    ++count;
  }
  return count;
}

stiction_contact Simulation::contact(int index) const {
  const mjContact& found = data_->contact[index];
  const auto obstacles = static_cast<int>(problem_.obstacle_count);
  // The frame's rows are the normal, from the first geom to the second, and two tangents.
  const RowMatrix frame = Map<const RowMatrix>(found.frame);
  const bool plane_second = found.geom2 < obstacles;
  const double side = plane_second ? -1.0 : 1.0;
  const int on = plane_second ? found.geom1 : found.geom2;
  const int other = plane_second ? found.geom2 : found.geom1;
  double force[6] = {};
  mj_contactForce(model_.get(), data_.get(), index, force);
  const Vector3d normal = side * frame.row(0).transpose();
  const Vector3d friction = side * (frame.row(1) * force[1] + frame.row(2) * force[2]).transpose();

  const auto velocity = [&](int geom) -> Vector3d {  // of its material point at the contact
    if (geom < obstacles) return Vector3d::Zero();
    stiction_body_state state{};
    body(static_cast<std::size_t>(geom - obstacles), state);
    const ConstVector centre(data_->xpos + 3 * (geom - obstacles + 1));
    return Vector3d(state.velocity) +
           Vector3d(state.angular_velocity).cross(ConstVector(found.pos) - centre);
  };
  const Vector3d slip = velocity(on) - velocity(other);

  stiction_contact told{};
  told.body = static_cast<std::size_t>(on - obstacles);
  told.against_body = other >= obstacles ? 1 : 0;
  told.other = static_cast<std::size_t>(other - (told.against_body ? obstacles : 0));
  Map<Vector3d>(told.normal) = normal;
  told.gap = found.dist;
  told.normal_force = force[0];
  Map<Vector3d>(told.friction_force) = friction;
  Map<Vector3d>(told.slip) = slip - slip.dot(normal) * normal;
  std::copy_n(found.pos, 3, told.position);
  const double mu = found.dim > 1 ? found.friction[0] : 0.0;
  const double used = model_->opt.cone == mjCONE_ELLIPTIC ? friction.norm()
                                                          : std::abs(force[1]) + std::abs(force[2]);
  told.sticks = used < (1.0 - 1e-9) * mu * force[0] ? 1 : 0;
  return told;
}

Saved* Simulation::save() const {
  return new Saved{Data(mj_copyData(nullptr, model_.get(), data_.get())), model_->nconmax,
                   model_->njmax};
}

void Simulation::restore(const Saved& saved) {
  model_->nconmax = saved.contact_room;
  model_->njmax = saved.row_room;
  model_->nstack = saved.data->nstack;
  data_.reset(mj_copyData(nullptr, model_.get(), saved.data.get()));
}

}  // namespace stiction_mujoco

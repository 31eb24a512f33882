// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record_store.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "reports/record/record_json.h"
#include "reports/record/whole_file.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kFolderMode = 0777;  // less what the umask takes
constexpr const char* kLatest = "latest";

std::string cause(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail(const std::string& action, const fs::path& path, int error) {
  throw std::runtime_error(
      fmt::format("Cannot {} \"{}\": {}.", action, path.string(), cause(error)));
}

// Closes on leaving the scope.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

// A new entry of a folder survives a power cut only once the folder is synced. Best effort.
void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) fsync(descriptor.get());
}

// The deepest files of a run, such as vtk/NAME/contacts_0001.vtp, must be writable at its end too.
void demand_room(const fs::path& out_dir) {
  constexpr std::size_t kMost = PATH_MAX - 200;
  const std::size_t bytes = out_dir.native().size();
  if (bytes <= kMost) return;
  throw std::runtime_error(fmt::format(
      "Reports cannot be written to \"{}…\": its path has {} bytes, and {} are the most "
      "that leave room for the names of files in it.",
      out_dir.string().substr(0, 60), bytes, kMost));
}

// The link to the last run may be there, and nothing else.
void demand_place_of_link(const fs::path& latest) {
  std::error_code none;
  const fs::file_status found = fs::symlink_status(latest, none);
  if (!fs::exists(found) || fs::is_symlink(found)) return;
  throw std::runtime_error(
      fmt::format("\"{}\" is a {}, where the link to the last run belongs: move it, or name "
                  "another folder for the reports.",
                  latest.string(), fs::is_directory(found) ? "folder" : "file"));
}

// mkdir either makes the folder or says that it is taken, in one step, so that two runs never
// share.
fs::path make_run_folder(const fs::path& out_dir) {
  const std::string stem = fmt::format("{:%Y-%m-%dT%H-%M-%SZ}", fmt::gmtime(std::time(nullptr)));
  for (int attempt = 1;; ++attempt) {
    const fs::path folder = out_dir / (attempt == 1 ? stem : fmt::format("{}-{}", stem, attempt));
    if (mkdir(folder.c_str(), kFolderMode) == 0) return folder;
    if (errno != EEXIST) fail("create folder", folder, errno);
  }
}

}  // namespace

RecordStore RecordStore::create(const fs::path& out_dir) {
  std::error_code error;
  const fs::path absolute = fs::absolute(out_dir, error);
  if (!error) demand_room(absolute);
  if (!error) fs::create_directories(absolute, error);
  if (error) fail("create folder", out_dir, error.value());
  demand_place_of_link(absolute / kLatest);
  fs::path folder = make_run_folder(absolute);
  fs::path records_file = folder / "records.jsonl";
  const int descriptor =
      open(records_file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, kFileMode);
  if (descriptor < 0) fail("create", records_file, errno);
  sync_folder(folder);
  sync_folder(absolute);
  return RecordStore(std::move(folder), std::move(records_file), descriptor);
}

RecordStore::RecordStore(fs::path folder, fs::path records_file, int descriptor)
    : folder_(std::move(folder)), records_file_(std::move(records_file)), descriptor_(descriptor) {}

RecordStore::~RecordStore() { close(descriptor_); }

bool RecordStore::cut_back() {
  torn_ = ftruncate(descriptor_, static_cast<off_t>(complete_bytes_)) != 0;
  return !torn_;
}

void RecordStore::append(const Record& record) {
  const std::string line = to_json_line(record) + '\n';
  const std::lock_guard lock(mutex_);
  const Writing writing;
  if (torn_ && !cut_back()) fail("mend the cut-off last line of", records_file_, errno);
  const auto now = std::chrono::steady_clock::now();
  const bool waits = std::chrono::duration<double>(now - waited_).count() >= wait_every_;
  if (waits) waited_ = now;
  const int error = write_fully(descriptor_, line, waits ? Wait::kYes : Wait::kNo);
  if (error != 0) {
    const bool whole = cut_back();
    throw std::runtime_error(fmt::format(
        "Cannot write the record of \"{}\" to \"{}\": {}; the {} record(s) before it are kept{}.",
        one_line(record.case_name), records_file_.string(), cause(error), complete_records_,
        whole ? "" : ", but a cut-off line stands behind them"));
  }
  complete_bytes_ += line.size();
  ++complete_records_;
}

void RecordStore::write_file(const std::string& name, std::string_view content) {
  const fs::path file = folder_ / name;
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
      file == records_file_) {
    throw std::runtime_error(
        fmt::format("\"{}\" is not a name for a file in \"{}\".", name, folder_.string()));
  }
  const std::lock_guard lock(mutex_);  // two writers of one name would share the temporary
  write_whole(file, content);
  files_.insert(file);
}

void RecordStore::finish() {
  // The run folder's name is this run's alone, so the temporary link is too.
  const fs::path out_dir = folder_.parent_path();
  const fs::path temporary = out_dir / (fmt::format(".{}.latest", folder_.filename().string()));
  const fs::path latest = out_dir / kLatest;
  const std::lock_guard lock(mutex_);
  const Writing writing;
  if (wait_every_ > 0.0 && fdatasync(descriptor_) != 0) fail("write", records_file_, errno);
  demand_place_of_link(latest);
  if (symlink(folder_.filename().c_str(), temporary.c_str()) != 0) fail("create", temporary, errno);
  if (rename(temporary.c_str(), latest.c_str()) != 0) {
    const int error = errno;
    unlink(temporary.c_str());
    fail("create link", latest, error);
  }
}

std::string RecordStore::last_words() {
  mutex_.lock();  // for good, before the files: write_file holds it while it writes one
  end_writing();
  if (complete_records_ == 0) {
    unlink(records_file_.c_str());
    for (const fs::path& file : files_) unlink(file.c_str());
    rmdir(folder_.c_str());  // stays when something else is in it
    return " before anything was finished";
  }
  return fmt::format(
      "; {} in {}; ./stiction report '{}' makes a page of {}",
      complete_records_ == 1 ? "1 finished record is"
                             : fmt::format("{} finished records are", complete_records_),
      records_file_.string(), folder_.string(), complete_records_ == 1 ? "it" : "them");
}

void RecordStore::tell_caller() const { tell_run_folder(folder_); }

void tell_run_folder(const std::filesystem::path& folder) {
  const char* const file = std::getenv("STICTION_RUN_FILE");
  if (file != nullptr) write_whole(file, folder.string() + "\n");
}

}  // namespace stiction

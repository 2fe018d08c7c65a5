#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace app {

/// Writes `bytes` to `path` so that a reader sees the old file or the whole new one, never a part:
/// a temporary file in the same folder is written, flushed to the disk and renamed.
/// Creates missing parent folders. Leaves no temporary file behind, also after Ctrl-C or `kill` (only `kill
/// -9` or a power failure can). A link stays a link: the file behind it is written. An existing file keeps
/// its permissions, a write-protected one is refused, and so is what is no regular file (a device, a pipe, a
/// folder). Throws IoError naming the file and the system's reason (no permission, disk full, not a folder).
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The whole file as bytes. Throws IoError naming the file and the reason.
std::string read_file(const std::filesystem::path& path);

/// Writes `text` to standard output and flushes it. Throws IoError if that fails (closed pipe, full disk).
void write_stdout(std::string_view text);

/// Makes sure, before any long computation, that files can be created in `folder` (created if missing).
/// Throws IoError otherwise.
void require_writable_folder(const std::filesystem::path& folder);

/// The project's root folder (where `renders/` lies): the source folder of this build.
std::filesystem::path project_root();

}  // namespace app

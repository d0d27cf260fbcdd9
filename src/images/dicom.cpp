// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slices are read by GDCM through ITK, and put together here: ITK's reader of series takes the distance of the first two slices for that of all, does not know
// of lattices that are not rectangular, as a tilted gantry makes them, and only warns of missing slices. The positions are those of DICOM PS3.3,
// C.7.6.2.1.1 (Image Position and Image Orientation). GDCM ends the program at some damaged files, which are therefore tried in a child process first.
#include "dicom.h"

#include "../differential/vector.h"
#include "change_of_coordinates.h"
#include "in_child.h"
#include "itk_reading.h"

#include <fmt/format.h>
#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {
namespace {

namespace fs = std::filesystem;

/// An error of so much of a step is one of rounding in the file.
constexpr double position_tolerance = 0.02;
constexpr double direction_tolerance = 1e-4;

struct Slice {
  std::string file, series;
  std::array<std::size_t, 2> size{};
  std::array<Vector, 2> step{};
  Point origin{};
  double height = 0; ///< along the normal

  std::string name() const { return fs::path(file).filename().string(); }
};

bool has_mark(const fs::path& file) {
  constexpr std::size_t preamble = 128;
  char bytes[preamble + 4] = {};
  std::ifstream in(file, std::ios::binary);
  return in.read(bytes, sizeof bytes) && std::memcmp(bytes + preamble, "DICM", 4) == 0;
}

/// Where the elements of a file end, as far as their lengths are told: that a file ends within one is told of it, whatever GDCM does then.
class Elements {
public:
  explicit Elements(const fs::path& file) : in_(file, std::ios::binary), size_(fs::file_size(file)) {
    constexpr std::uint64_t preamble = 132;
    at_ = preamble;
  }

  /// walks over all elements, or up to the first whose length is not told, such as compressed voxels.
  bool are_whole() {
    std::string syntax = "1.2.840.10008.1.2.1"; // of the first group
    while (at_ < size_) {
      std::uint16_t group = 0;
      if (!read(group, false))
        return false;
      const bool is_meta = group == 2;
      const bool big = !is_meta && syntax == "1.2.840.10008.1.2.2",
                 implicit = !is_meta && syntax == "1.2.840.10008.1.2";
      if (!is_meta && syntax == "1.2.840.10008.1.2.1.99") // deflated
        return true;
      in_.seekg(std::streamoff(at_));
      std::uint16_t element = 0;
      if (!read(group, big) || !read(element, big))
        return false;
      std::uint32_t length = 0;
      std::uint64_t header = 8;
      if (implicit) {
        if (!read(length, big))
          return false;
      } else {
        char type[2] = {};
        std::uint16_t short_length = 0;
        if (!in_.read(type, sizeof type) || !read(short_length, big))
          return false;
        length = short_length;
        static const std::set<std::string> long_types{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                      "SV", "UC", "UN", "UR", "UT", "UV"};
        if (long_types.contains(std::string(type, sizeof type))) {
          header = 12;
          if (!read(length, big))
            return false;
        }
      }
      if (length == std::numeric_limits<std::uint32_t>::max())
        return true;
      if (length > size_ - std::min(size_, at_ + header))
        return false;
      if (is_meta && element == 0x10) {
        syntax.assign(length, '\0');
        in_.read(syntax.data(), std::streamsize(length));
        syntax.resize(std::min(syntax.find('\0'), syntax.size()));
      }
      at_ += header + length;
      in_.seekg(std::streamoff(at_));
    }
    return true;
  }

private:
  template <class Number> bool read(Number& number, bool big) {
    unsigned char bytes[sizeof(Number)] = {};
    if (!in_.read(reinterpret_cast<char*>(bytes), sizeof bytes))
      return false;
    number = 0;
    for (std::size_t i = 0; i < sizeof bytes; ++i)
      number = Number(number | Number(bytes[i]) << (8 * (big ? sizeof bytes - 1 - i : i)));
    return true;
  }

  std::ifstream in_;
  std::uint64_t size_, at_ = 0;
};

itk::GDCMImageIO::Pointer open(const std::string& file) {
  if (!Elements(file).are_whole())
    throw std::runtime_error(
        fmt::format("its slice '{}' is truncated, or damaged", fs::path(file).filename().string()));
  const auto io = itk::GDCMImageIO::New();
  io->SetFileName(file);
  try {
    io->ReadImageInformation();
  } catch (const itk::ExceptionObject&) {
    throw std::runtime_error(
        fmt::format("its slice '{}' is damaged, or is no image", fs::path(file).filename().string()));
  }
  return io;
}

/// Keeps GDCM from printing what is told by exceptions, as long as it lives.
class Quiet_gdcm {
public:
  Quiet_gdcm() : warns_(gdcm::Trace::GetWarningFlag()), tells_errors_(gdcm::Trace::GetErrorFlag()) {
    gdcm::Trace::SetWarning(false);
    gdcm::Trace::SetError(false);
  }
  Quiet_gdcm(const Quiet_gdcm&) = delete;
  Quiet_gdcm& operator=(const Quiet_gdcm&) = delete;
  ~Quiet_gdcm() {
    gdcm::Trace::SetWarning(warns_);
    gdcm::Trace::SetError(tells_errors_);
  }

private:
  bool warns_, tells_errors_;
};

/// \param bytes  that an attempt may take beside those of the file
/// \throws std::runtime_error if an attempt at a slice ends a process
void try_in_child(const std::vector<std::string>& files, std::size_t bytes,
                  const std::function<void(const std::string&)>& attempt) {
  constexpr std::size_t slices_a_second = 10, usual_bytes = std::size_t(1) << 28U, copies = 8;
  Child_limits limits;
  limits.seconds += unsigned(files.size() / slices_a_second);
  std::size_t largest = 0;
  for (const std::string& file : files)
    largest = std::max<std::size_t>(largest, fs::file_size(file));
  limits.bytes = usual_bytes + copies * (largest + bytes);
  if (const auto i = first_that_ends_a_child(
          files.size(), [&](std::size_t k) { attempt(files[k]); }, limits))
    throw std::runtime_error(fmt::format("its slice '{}' is damaged", fs::path(files[*i]).filename().string()));
}

Slice slice_of(const std::string& file) {
  const auto io = open(file);
  Slice slice;
  slice.file = file;
  itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), "0020|000e", slice.series);
  if (io->GetNumberOfComponents() != 1)
    throw std::runtime_error(
        fmt::format("its slice '{}' has {} values per voxel; expected one", slice.name(), io->GetNumberOfComponents()));
  if (io->GetNumberOfDimensions() > 2 && io->GetDimensions(2) != 1)
    throw std::runtime_error(
        fmt::format("its file '{}' has {} frames; expected one slice a file", slice.name(), io->GetDimensions(2)));
  for (unsigned a = 0; a < 2; ++a) {
    slice.size[a] = io->GetDimensions(a);
    const std::vector<double> direction = io->GetDirection(a);
    for (std::size_t i = 0; i < 3; ++i)
      slice.step[a][i] = io->GetSpacing(a) * direction[i] + 0.0;
  }
  for (unsigned i = 0; i < 3; ++i)
    slice.origin[i] = io->GetOrigin(i) + 0.0;
  return slice;
}

/// the slices that a path means.
std::vector<Slice> slices_of(const std::string& path) {
  const bool is_folder = fs::is_directory(path);
  const fs::path folder = is_folder ? fs::path(path) : fs::absolute(path).parent_path();
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && has_mark(entry.path()))
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw std::runtime_error("it is a folder without DICOM slices");
  try_in_child(files, 0, slice_of);
  std::vector<Slice> slices;
  const std::string wanted = is_folder ? "" : slice_of(path).series;
  std::set<std::string> series;
  for (const std::string& file : files) {
    Slice slice = slice_of(file);
    if (!is_folder && slice.series != wanted)
      continue;
    series.insert(slice.series);
    slices.push_back(std::move(slice));
  }
  if (series.size() > 1)
    throw std::runtime_error(
        fmt::format("the slices of {} series are in it; give one slice of that which is meant", series.size()));
  return slices;
}

/// \throws std::runtime_error if slices differ in what they must have in common
void require_alike(const std::vector<Slice>& slices) {
  const Slice& first = slices.front();
  for (const Slice& slice : slices) {
    if (slice.size != first.size)
      throw std::runtime_error(fmt::format("its slice '{}' has {} x {} voxels, '{}' has {} x {}", slice.name(),
                                           slice.size[0], slice.size[1], first.name(), first.size[0], first.size[1]));
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(slice.step[a][i] - first.step[a][i]) <= direction_tolerance * norm(first.step[a])))
          throw std::runtime_error(fmt::format("its slice '{}' has another orientation or size of voxels than '{}'",
                                               slice.name(), first.name()));
  }
}

/// sorts the slices along their normal.
/// \return the step from each to the next
/// \throws std::runtime_error if that is not the same everywhere
Vector order(std::vector<Slice>& slices) {
  const auto& [u, v] = slices.front().step;
  const Vector normal = cross(u, v);
  const double length = norm(normal);
  for (Slice& slice : slices)
    slice.height = dot(normal, slice.origin) / length;
  std::stable_sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) { return a.height < b.height; });
  std::vector<double> gaps;
  for (std::size_t k = 0; k + 1 < slices.size(); ++k)
    gaps.push_back(slices[k + 1].height - slices[k].height);
  std::vector<double> sorted = gaps;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const std::string where = fmt::format("'{}' and '{}'", slices[k].name(), slices[k + 1].name());
    if (!(gaps[k] > position_tolerance * usual) || usual == 0)
      throw std::runtime_error(fmt::format("its slices {} are in the same place", where));
    const double steps = gaps[k] / usual;
    if (std::abs(steps - 1) <= position_tolerance)
      continue;
    if (steps > 1.5 && std::abs(steps - std::round(steps)) <= position_tolerance * steps)
      throw std::runtime_error(fmt::format("{} of its slices {} missing between {}", std::round(steps) - 1,
                                           std::round(steps) > 2 ? "are" : "is", where));
    throw std::runtime_error(fmt::format(
        "the distance of its slices {} is {:.6g}, of others {:.6g}; expected equal ones", where, gaps[k], usual));
  }
  const Vector step = (1 / double(slices.size() - 1)) * (slices.back().origin - slices.front().origin);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const double away = norm(slices[k].origin - slices.front().origin - double(k) * step);
    if (!(away <= position_tolerance * usual * 2))
      throw std::runtime_error(
          fmt::format("its slice '{}' is shifted by {:.4g} against the others", slices[k].name(), away));
  }
  return step;
}

} // namespace

bool may_be_dicom(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error) || (fs::is_regular_file(path, error) && has_mark(path));
}

Image read_dicom(const std::string& path, const Image_reading_options& options) {
  const Quiet_gdcm quiet;
  std::vector<Slice> slices = slices_of(path);
  constexpr std::size_t least_size = 4;
  if (slices.size() < least_size)
    throw std::runtime_error(fmt::format("it has {} slices; expected at least {}", slices.size(), least_size));
  require_alike(slices);
  Image image;
  Lattice& lattice = image.lattice;
  const std::array<Vector, 2> in_slice = slices.front().step;
  lattice.step = {in_slice[0], in_slice[1], order(slices)};
  lattice.origin = slices.front().origin;
  lattice.size = {slices.front().size[0], slices.front().size[1], slices.size()};
  for (std::size_t a = 0; a < 2; ++a)
    if (lattice.size[a] < least_size)
      throw std::runtime_error(
          fmt::format("its size along axis {} is {}; expected at least {}", a + 1, lattice.size[a], least_size));
  if (!inverse_of_columns(lattice.step))
    throw std::runtime_error("its direction matrix is singular");
  const std::size_t n = lattice.size[0] * lattice.size[1];
  image.voxels = room_for_voxels(double(n) * double(slices.size()), options);
  std::vector<std::string> files;
  for (const Slice& slice : slices)
    files.push_back(slice.file);
  try_in_child(files, n * sizeof(float), [n](const std::string& file) { read_voxels(*open(file), n); });
  for (const Slice& slice : slices) {
    const auto io = open(slice.file);
    try {
      const Voxels voxels = read_voxels(*io, n);
      image.voxels.insert(image.voxels.end(), voxels.begin(), voxels.end());
    } catch (const itk::ExceptionObject&) {
      throw std::runtime_error(fmt::format("its slice '{}' is damaged or truncated", slice.name()));
    }
  }
  return image;
}

} // namespace CGAL::Extremal_mesh_3

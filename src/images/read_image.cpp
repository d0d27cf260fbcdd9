// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// This and dicom.cpp are the only files that know ITK. Its readers are made directly: no factories, and nothing that another user of ITK in
// the same program could see.

#include <CGAL/Extremal_mesh_3/Image.h>

#include "change_of_coordinates.h"
#include "dicom.h"
#include "image_headers.h"
#include "itk_reading.h"
#include "vti.h"

#include <fmt/format.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVTKImageIO.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <mutex>
#include <new>

namespace CGAL::Extremal_mesh_3 {
namespace {

using Component = itk::IOComponentEnum;

struct Format {
  const char* extension;
  const char* name;
  Stored_voxels (*find_voxels)(const std::string&);
  itk::ImageIOBase::Pointer (*make_reader)();
};

template <typename Reader> itk::ImageIOBase::Pointer make_reader() {
  return Reader::New().GetPointer();
}

constexpr Format formats[] = {
    {".nrrd", "NRRD", find_nrrd_voxels, make_reader<itk::NrrdImageIO>},
    {".nhdr", "NRRD", find_nrrd_voxels, make_reader<itk::NrrdImageIO>},
    {".mha", "MetaImage", find_meta_voxels, make_reader<itk::MetaImageIO>},
    {".mhd", "MetaImage", find_meta_voxels, make_reader<itk::MetaImageIO>},
    {".nii", "NIfTI", find_nifti_voxels, make_reader<itk::NiftiImageIO>},
    {".nii.gz", "NIfTI", find_nifti_voxels, make_reader<itk::NiftiImageIO>},
    {".vtk", "VTK", find_vtk_voxels, make_reader<itk::VTKImageIO>},
};

// Fewer nodes along an axis hold no surface with third derivatives.
constexpr std::size_t least_size = 4;

std::string lower_case_name(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

const Format& format_of(const std::string& file) {
  const std::string name = lower_case_name(file);
  for (const Format& format : formats)
    if (name.ends_with(format.extension))
      return format;
  throw std::runtime_error("its name has none of the extensions that are read: .nrrd .nhdr .mha .mhd .nii .nii.gz "
                           ".vtk .vti; nor is it a DICOM slice");
}

void check_file(const std::string& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw std::runtime_error("it does not exist");
  if (!std::filesystem::is_regular_file(status))
    throw std::runtime_error("it is not a regular file");
  if (std::filesystem::file_size(file, error) == 0)
    throw std::runtime_error("it is empty");
  if (!std::ifstream(file))
    throw std::runtime_error("it cannot be opened");
}

// ITK's warnings go to the console; whether they do is a global setting of ITK.
class Silence {
public:
  Silence() : display_(itk::Object::GetGlobalWarningDisplay()) { itk::Object::SetGlobalWarningDisplay(false); }
  ~Silence() { itk::Object::SetGlobalWarningDisplay(display_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  bool display_;
};

void check_shape(const itk::ImageIOBase& io) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  bool is_3d = dimensions >= 3;
  for (unsigned a = 3; a < dimensions; ++a)
    is_3d = is_3d && io.GetDimensions(a) == 1;
  if (!is_3d) {
    std::string sizes;
    for (unsigned a = 0; a < dimensions; ++a)
      sizes += fmt::format("{}{}", a == 0 ? "" : " x ", io.GetDimensions(a));
    throw std::runtime_error(fmt::format("it is not 3D: its size is {}", sizes));
  }
  if (io.GetNumberOfComponents() != 1)
    throw std::runtime_error(fmt::format("it has {} values per voxel; expected one", io.GetNumberOfComponents()));
}

// NIfTI stores 3.2 as the float nearest to it: takes a number that is a float to the shortest decimal that stands for
// the same float, so that the same image has the same lattice in every format.
double without_rounding_of_float(double x) {
  const auto narrow = static_cast<float>(x);
  return static_cast<double>(narrow) == x ? std::stod(fmt::format("{}", narrow)) : x;
}

Lattice lattice_of(const itk::ImageIOBase& io, bool stores_floats) {
  Lattice lattice;
  for (unsigned a = 0; a < 3; ++a) {
    lattice.size[a] = io.GetDimensions(a);
    if (lattice.size[a] < least_size)
      throw std::runtime_error(
          fmt::format("its size along axis {} is {}; expected at least {}", a + 1, lattice.size[a], least_size));
    double spacing = io.GetSpacing(a);
    double origin = io.GetOrigin(a);
    if (stores_floats) {
      spacing = without_rounding_of_float(spacing);
      origin = without_rounding_of_float(origin);
    }
    if (!(spacing > 0 && std::isfinite(spacing)))
      throw std::runtime_error(
          fmt::format("its spacing along axis {} is {}; expected a positive number", a + 1, spacing));
    if (!std::isfinite(origin))
      throw std::runtime_error(fmt::format("its origin along axis {} is {}", a + 1, origin));
    lattice.origin[a] = origin + 0.0; // no −0
    const std::vector<double> direction = io.GetDirection(a);
    for (std::size_t i = 0; i < 3; ++i)
      lattice.step[a][i] = spacing * direction[i] + 0.0;
  }
  if (!inverse_of_columns(lattice.step))
    throw std::runtime_error("its direction matrix is singular");
  return lattice;
}

std::uint64_t number_of_voxels(const Lattice& lattice) {
  std::uint64_t n = 1;
  for (std::size_t size : lattice.size)
    if (__builtin_mul_overflow(n, size, &n))
      n = std::numeric_limits<std::uint64_t>::max();
  if (n > std::numeric_limits<std::uint64_t>::max() / sizeof(double))
    throw std::runtime_error(fmt::format("its size is {} x {} x {}, which is not possible", lattice.size[0],
                                         lattice.size[1], lattice.size[2]));
  return n;
}

/// calls use(Number()) for the type of number that the components have.
template <class Use> void with_number(Component component, const Use& use) {
  switch (component) {
  case Component::UCHAR:
    return use(static_cast<unsigned char>(0));
  case Component::CHAR:
    return use(static_cast<signed char>(0));
  case Component::USHORT:
    return use(static_cast<unsigned short>(0));
  case Component::SHORT:
    return use(static_cast<short>(0));
  case Component::UINT:
    return use(0U);
  case Component::INT:
    return use(0);
  case Component::ULONG:
    return use(0UL);
  case Component::LONG:
    return use(0L);
  case Component::ULONGLONG:
    return use(0ULL);
  case Component::LONGLONG:
    return use(0LL);
  case Component::FLOAT:
    return use(0.0F);
  case Component::DOUBLE:
    return use(0.0);
  default:
    throw std::runtime_error("the type of its voxels is not supported");
  }
}

void read_by_itk(itk::ImageIOBase& io, std::size_t n, Voxels& voxels) {
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a)
    region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  voxels.resize(n);
  if (io.GetComponentType() == Component::FLOAT)
    return io.Read(voxels.data());
  std::vector<char> bytes(n * io.GetComponentSize());
  io.Read(bytes.data());
  with_number(io.GetComponentType(), [&](auto number) {
    for (std::size_t i = 0; i < n; ++i) {
      std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
      voxels[i] = static_cast<float>(number);
    }
  });
}

/// turns `count` numbers of type Number, as they are in a file, into floats.
template <class Number> void convert(const char* bytes, std::size_t count, bool swapped, float* out) {
  std::array<char, sizeof(Number)> bytes_of_number;
  Number number;
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(bytes_of_number.data(), bytes + i * sizeof(Number), sizeof(Number));
    if (swapped)
      std::reverse(bytes_of_number.begin(), bytes_of_number.end());
    std::memcpy(&number, bytes_of_number.data(), sizeof(Number));
    out[i] = static_cast<float>(number);
  }
}

/// reads the voxels without ITK, which takes them all at once.
/// \param voxels  has room for them
void read_by_pieces(const itk::ImageIOBase& io, const Stored_voxels& stored, std::size_t n, Voxels& voxels) {
  constexpr itk::IOByteOrderEnum machine =
      std::endian::native == std::endian::little ? itk::IOByteOrderEnum::LittleEndian : itk::IOByteOrderEnum::BigEndian;
  const itk::IOByteOrderEnum order = io.GetByteOrder();
  const bool swapped = stored.are_swapped || (order != machine && order != itk::IOByteOrderEnum::OrderNotApplicable);
  std::vector<float> values;
  with_number(io.GetComponentType(), [&](auto number) {
    for_each_piece(stored, n, sizeof number, [&](const char* bytes, std::size_t count) {
      values.resize(count);
      convert<decltype(number)>(bytes, count, swapped, values.data());
      voxels.insert(voxels.end(), values.begin(), values.end());
    });
  });
}

void require_finite(const Voxels& voxels) {
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (!std::isfinite(voxels[i]))
      throw std::runtime_error(fmt::format("its voxel {} is {}; expected a finite number", i, voxels[i]));
}

} // namespace

Voxels read_voxels(itk::ImageIOBase& io, std::size_t n) {
  Voxels voxels;
  read_by_itk(io, n, voxels);
  require_finite(voxels);
  return voxels;
}

Voxels room_for_voxels(double number, const Image_reading_options& options) {
  const char* const usual = std::getenv("TMPDIR");
  Voxels voxels;
  if (number * sizeof(float) > double(options.memory_limit) / 2)
    voxels = Voxels(Voxel_allocator(!options.scratch_folder.empty() ? options.scratch_folder
                                    : usual && *usual               ? usual
                                                                    : "/tmp"));
  voxels.reserve(std::size_t(number));
  return voxels;
}

namespace {

/// \throws std::runtime_error if so many bytes are more than allowed
void require_memory(double bytes, std::uint64_t limit) {
  constexpr double mega = 0x1p20;
  if (bytes > double(limit))
    throw std::runtime_error(
        fmt::format("to read it takes {:.0f} MB of memory, more than the {:.0f} MB that it may take", bytes / mega,
                    double(limit) / mega));
}

Image read(const std::string& file, const Image_reading_options& options) {
  static std::mutex itk_mutex; // NRRD's error messages and the silence are global
  if (may_be_dicom(file)) {
    const std::scoped_lock lock(itk_mutex);
    const Silence silence;
    return read_dicom(file, options);
  }
  check_file(file);
  if (lower_case_name(file).ends_with(".vti"))
    return read_vti(file, options);
  const Format& format = format_of(file);
  const Stored_voxels stored = format.find_voxels(file);

  const std::scoped_lock lock(itk_mutex);
  const Silence silence;
  try {
    const itk::ImageIOBase::Pointer io = format.make_reader();
    io->SetFileName(file);
    io->ReadImageInformation();
    check_shape(*io);
    Image image;
    image.lattice = lattice_of(*io, format.find_voxels == find_nifti_voxels);
    const std::uint64_t n = number_of_voxels(image.lattice);
    const std::uintmax_t size = std::filesystem::file_size(stored.file);
    if (stored.is_plain) {
      require_possible_size(stored, n, io->GetComponentSize());
      image.voxels = room_for_voxels(double(n), options);
      read_by_pieces(*io, stored, n, image.voxels);
    } else {
      const bool are_floats = io->GetComponentType() == Component::FLOAT; // others are read as they are first
      require_memory(double(n) * double(sizeof(float) + (are_floats ? 0 : io->GetComponentSize())),
                     options.memory_limit);
      require_complete(stored, n, io->GetComponentSize());
      read_by_itk(*io, n, image.voxels);
    }
    require_finite(image.voxels);
    // Neither we nor ITK's readers would always tell if the data had come to an end before theirs.
    if (std::filesystem::file_size(stored.file) < size)
      throw std::runtime_error("it became shorter while it was read");
    return image;
  } catch (const itk::ExceptionObject&) { // its text has several lines, and names of functions
    throw std::runtime_error(fmt::format("it is damaged, or is not in the format {}", format.name));
  }
}

} // namespace

Image read_image(const std::string& file, const Image_reading_options& options) {
  try {
    return read(file, options);
  } catch (const std::bad_alloc&) {
    throw Io_error(fmt::format("cannot read '{}': it is larger than memory", file));
  } catch (const std::exception& error) {
    std::string message = error.what(); // may quote the file's header, with anything in it
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    throw Io_error(fmt::format("cannot read '{}': {}", file, message));
  }
}

} // namespace CGAL::Extremal_mesh_3

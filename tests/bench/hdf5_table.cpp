// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/hdf5_table.h"

#include "bench/sqlite_rows.h"

#ifdef CHIRON_HAS_HDF5
#include <hdf5.h>
#endif

namespace chiron::bench {

#ifdef CHIRON_HAS_HDF5
namespace {
constexpr hsize_t kSecond = 1000;

double readBlock(const std::filesystem::path& file, hsize_t row, hsize_t rows, hsize_t column,
                 hsize_t columns) {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t data = H5Dopen2(id, "samples", H5P_DEFAULT);
    const hid_t space = H5Dget_space(data);
    if (rows == 0) {
        hsize_t size[2] = {0, 0};
        H5Sget_simple_extent_dims(space, size, nullptr);
        rows = size[0];
    }
    const hsize_t start[2] = {row, column};
    const hsize_t count[2] = {rows, columns};
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
    const hid_t memory = H5Screate_simple(2, count, nullptr);
    std::vector<double> values(rows * columns);
    H5Dread(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    double sum = 0.0;
    for (const double v : values)
        sum += v;
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(data);
    H5Fclose(id);
    return sum;
}
} // namespace

bool Hdf5Table::available() {
    return true;
}

void Hdf5Table::write(const std::filesystem::path& file, std::span<const core::HapticFrame> frames) {
    const hid_t id = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    hsize_t size[2] = {0, kRowChannels};
    const hsize_t most[2] = {H5S_UNLIMITED, kRowChannels};
    const hsize_t chunk[2] = {kSecond, 1}; // a column a chunk: the best layout for compression and for scans
    const hid_t space = H5Screate_simple(2, size, most);
    const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(layout, 2, chunk);
    H5Pset_shuffle(layout);
    H5Pset_deflate(layout, 1);
    const hid_t data = H5Dcreate2(id, "samples", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, layout, H5P_DEFAULT);
    std::vector<std::array<double, kRowChannels>> rows;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        rows.push_back(rowOf(frames[i]));
        if (rows.size() < kSecond && i + 1 < frames.size())
            continue;
        const hsize_t start[2] = {size[0], 0};
        const hsize_t count[2] = {rows.size(), kRowChannels};
        size[0] += rows.size();
        H5Dset_extent(data, size);
        const hid_t target = H5Dget_space(data);
        H5Sselect_hyperslab(target, H5S_SELECT_SET, start, nullptr, count, nullptr);
        const hid_t memory = H5Screate_simple(2, count, nullptr);
        H5Dwrite(data, H5T_NATIVE_DOUBLE, memory, target, H5P_DEFAULT, rows.data());
        H5Sclose(memory);
        H5Sclose(target);
        H5Fflush(id, H5F_SCOPE_LOCAL);
        rows.clear();
    }
    H5Dclose(data);
    H5Pclose(layout);
    H5Sclose(space);
    H5Fclose(id);
}

double Hdf5Table::readSpan(const std::filesystem::path& file, std::uint64_t first, std::uint64_t frames) {
    return readBlock(file, first, frames, 0, kRowChannels);
}

double Hdf5Table::scanOne(const std::filesystem::path& file) {
    return readBlock(file, 0, 0, 8, 1);
}
#else
bool Hdf5Table::available() {
    return false;
}
void Hdf5Table::write(const std::filesystem::path&, std::span<const core::HapticFrame>) {}
double Hdf5Table::readSpan(const std::filesystem::path&, std::uint64_t, std::uint64_t) {
    return 0.0;
}
double Hdf5Table::scanOne(const std::filesystem::path&) {
    return 0.0;
}
#endif

} // namespace chiron::bench

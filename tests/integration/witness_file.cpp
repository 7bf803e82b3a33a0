// SPDX-License-Identifier: GPL-3.0-or-later
#include "witness_file.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

std::unique_ptr<WitnessFile> WitnessFile::create(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (descriptor < 0 || posix_fallocate(descriptor, 0, sizeof(Witness)) != 0) {
        std::perror(path.c_str());
        std::abort();
    }
    std::unique_ptr<WitnessFile> file(new WitnessFile(descriptor));
    new (file->m_witness) Witness;
    return file;
}

std::unique_ptr<WitnessFile> WitnessFile::open(const std::string& path) {
    return std::unique_ptr<WitnessFile>(new WitnessFile(::open(path.c_str(), O_RDWR | O_CLOEXEC)));
}

WitnessFile::WitnessFile(int descriptor) {
    void* base = mmap(nullptr, sizeof(Witness), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (base == MAP_FAILED) {
        std::perror("witness");
        std::abort();
    }
    ::close(descriptor);
    m_witness = static_cast<Witness*>(base);
}

WitnessFile::~WitnessFile() {
    munmap(m_witness, sizeof(Witness));
}

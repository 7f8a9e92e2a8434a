#include "io/system/private_folder.h"

#include <sys/stat.h>
#include <unistd.h>

PrivateFolder make_private_folder(const std::filesystem::path& folder) {
    if (::mkdir(folder.c_str(), S_IRWXU) == 0)
        return PrivateFolder::ready;
    struct stat status = {};
    if (::lstat(folder.c_str(), &status) != 0)
        return PrivateFolder::not_created;
    const bool is_private = S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() &&
                            (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
    return is_private ? PrivateFolder::ready : PrivateFolder::not_private;
}

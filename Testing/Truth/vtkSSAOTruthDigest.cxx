// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthDigest.h"

#include <vtksys/MD5.h>

#include <algorithm>

//------------------------------------------------------------------------------
vtkSSAOTruthDigest::vtkSSAOTruthDigest()
  : Md5(vtksysMD5_New())
{
  vtksysMD5_Initialize(this->Md5);
}

//------------------------------------------------------------------------------
vtkSSAOTruthDigest::~vtkSSAOTruthDigest()
{
  vtksysMD5_Delete(this->Md5);
}

//------------------------------------------------------------------------------
void vtkSSAOTruthDigest::AddBytes(const void* bytes, std::size_t size)
{
  // vtksysMD5_Append counts bytes in an int.
  const std::size_t largest = std::size_t(1) << 30;
  const unsigned char* next = static_cast<const unsigned char*>(bytes);
  while (size > 0)
  {
    const std::size_t part = std::min(size, largest);
    vtksysMD5_Append(this->Md5, next, static_cast<int>(part));
    next += part;
    size -= part;
  }
}

//------------------------------------------------------------------------------
std::string vtkSSAOTruthDigest::GetHex()
{
  char hex[32];
  vtksysMD5_FinalizeHex(this->Md5, hex);
  return std::string(hex, 32);
}

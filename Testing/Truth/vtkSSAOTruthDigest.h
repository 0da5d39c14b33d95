// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthDigest
 * @brief   MD5 of a sequence of numbers, for keys and checksums of the cache.
 */

#ifndef vtkSSAOTruthDigest_h
#define vtkSSAOTruthDigest_h

#include <cstddef>
#include <string>
#include <vector>

struct vtksysMD5_s;

class vtkSSAOTruthDigest
{
public:
  vtkSSAOTruthDigest();
  ~vtkSSAOTruthDigest();
  vtkSSAOTruthDigest(const vtkSSAOTruthDigest&) = delete;
  void operator=(const vtkSSAOTruthDigest&) = delete;

  /**
   * Appends raw bytes.
   */
  void AddBytes(const void* bytes, std::size_t size);

  /**
   * Appends one number.
   */
  template <typename T>
  void Add(const T& value)
  {
    this->AddBytes(&value, sizeof(T));
  }

  /**
   * Appends the length of an array and its elements.
   */
  template <typename T>
  void Add(const std::vector<T>& values)
  {
    this->Add(static_cast<unsigned long long>(values.size()));
    this->AddBytes(values.data(), values.size() * sizeof(T));
  }

  /**
   * Ends the sequence; the digest as 32 hexadecimal digits.
   */
  std::string GetHex();

private:
  vtksysMD5_s* Md5;
};

#endif

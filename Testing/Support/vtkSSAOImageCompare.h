// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOImageCompare
 * @brief   Strict comparison of pictures with baselines.
 *
 * VTK's own comparison tolerates up to 105 grey levels, shifted and averaged pixels, so that it
 * passes with the occlusion's blur dropped. Here each pixel is compared with the baseline's pixel
 * at the same place. Printed: the largest difference of a channel, in 1/255, and the share of the
 * pixels with a channel that differs by more than the tolerance. On failure the picture got and
 * the difference, amplified, are written to the -T folder.
 *
 * With the environment variable SSAO_ACCEPT_BASELINES set to 1, a picture that fails becomes the
 * baseline.
 */

#ifndef vtkSSAOImageCompare_h
#define vtkSSAOImageCompare_h

#include <string>

class vtkImageData;
class vtkSSAOTestMonitor;

/**
 * A picture passes if the share of the pixels that differ by more than Channel in some channel is
 * at most Fraction, and no channel differs by more than Largest.
 */
struct vtkSSAOTolerance
{
  int Channel = 0;       ///< 1/255
  double Fraction = 0.0; ///< 0 to 1
  int Largest = 255;     ///< 1/255
};

/**
 * The comparison of two pictures.
 */
struct vtkSSAODifference
{
  bool SameSize = false;
  int Largest = 255;
  double Fraction = 1.0;
};

class vtkSSAOImageCompare
{
public:
  /**
   * Takes -V <baseline>.png and -T <folder> from the arguments of a test.
   */
  vtkSSAOImageCompare(int argc, char* argv[], vtkSSAOTestMonitor& monitor);

  /**
   * Compare an RGB picture with the baseline of the test, or of one of its cases:
   * <Test>-<case>.png. A missing baseline is a failure.
   */
  bool Compare(vtkImageData* picture, const vtkSSAOTolerance& tolerance,
    const std::string& caseName = std::string());

  /**
   * Compare two pictures in memory. Pictures are unsigned char with equally many components.
   */
  static vtkSSAODifference Difference(vtkImageData* a, vtkImageData* b, int channelTolerance);

private:
  std::string Baseline;
  std::string Folder;
  vtkSSAOTestMonitor& Monitor;
};

#endif

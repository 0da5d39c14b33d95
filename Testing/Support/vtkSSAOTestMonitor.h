// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTestMonitor
 * @brief   What a test expects, and what nobody should say meanwhile.
 *
 * Lives as long as the test function. Prints each expectation with the value met, counts the
 * failures, and listens to VTK's output window and to OpenGL: a warning, an error or an OpenGL
 * error fails the test, unless it was expected through vtkSSAOErrorObserver.
 */

#ifndef vtkSSAOTestMonitor_h
#define vtkSSAOTestMonitor_h

#include "vtkSmartPointer.h" // For members

#include <string>
#include <vector>

class vtkObject;
class vtkOutputWindow;
class vtkRenderWindow;

class vtkSSAOTestMonitor
{
public:
  vtkSSAOTestMonitor();
  ~vtkSSAOTestMonitor();
  vtkSSAOTestMonitor(const vtkSSAOTestMonitor&) = delete;
  void operator=(const vtkSSAOTestMonitor&) = delete;

  ///@{
  /**
   * Note an expectation; false if it is not met.
   */
  bool Expect(bool met, const std::string& what);
  bool ExpectEqual(double got, double wanted, const std::string& what);
  bool ExpectNear(double got, double wanted, double tolerance, const std::string& what);
  bool ExpectAtLeast(double got, double limit, const std::string& what);
  bool ExpectAtMost(double got, double limit, const std::string& what);
  ///@}

  /**
   * Have OpenGL report the errors of a window's context (OpenGL 4.3 or later). The window must have
   * rendered.
   */
  void Watch(vtkRenderWindow* window);

  /**
   * The messages of VTK's output window and of OpenGL since construction or Forget().
   */
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  void Forget() { this->Messages.clear(); }

  /**
   * Whether messages count and are printed; off while something draws that is not under test.
   */
  void SetListening(bool listening) { this->Listening = listening; }

  /**
   * For OpenGL and the output window only.
   */
  void AddMessage(const std::string& message);

  /**
   * What the test returns: EXIT_FAILURE if an expectation was not met or a message was met.
   */
  int GetResult();

private:
  vtkSmartPointer<vtkOutputWindow> Window;
  vtkSmartPointer<vtkOutputWindow> Before;
  std::vector<std::string> Messages;
  int Failures = 0;
  bool Listening = true;
};

/**
 * Number of OpenGL objects of a kind ("Texture", "Framebuffer", "Program" ...) in the window's
 * context; 0 where there is no way to ask.
 */
int vtkSSAOCountObjects(vtkRenderWindow* window, const std::string& kind);

/**
 * Counts and silences the errors and warnings of one object.
 */
class vtkSSAOErrorObserver
{
public:
  explicit vtkSSAOErrorObserver(vtkObject* object);
  ~vtkSSAOErrorObserver();
  vtkSSAOErrorObserver(const vtkSSAOErrorObserver&) = delete;
  void operator=(const vtkSSAOErrorObserver&) = delete;

  int GetErrors() const { return this->Errors; }
  int GetWarnings() const { return this->Warnings; }
  const std::string& GetText() const { return this->Text; }
  void Reset();

private:
  vtkSmartPointer<vtkObject> Object;
  std::vector<unsigned long> Tags;
  int Errors = 0;
  int Warnings = 0;
  std::string Text;
};

#endif

package org.opencv.core;

/**
 * Loads OpenCV's native library for the class loader that has OpenCV's classes: a native library
 * belongs to that of the class which loads it. {@code org.urbi.sim.vision.OpenCv} puts this class
 * there where it is not.
 */
final class LibraryLoader {
  private LibraryLoader() {}

  /** Loads the library in a file. */
  @SuppressWarnings("restricted") // To load it is what this class is for.
  static void load(String file) {
    System.load(file);
  }
}

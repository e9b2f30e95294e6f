package urbi;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The median of a fixed number of measurements: one that is far off does not count. */
public class MedianFilter {
  private final int size;
  private final List<Double> sorted = new ArrayList<>();

  /**
   * @param size how many measurements there are to be
   */
  public MedianFilter(int size) {
    if (size < 1) {
      throw new IllegalArgumentException("a median of " + size + " numbers");
    }
    this.size = size;
  }

  public void addElement(double measurement) {
    int found = Collections.binarySearch(sorted, measurement);
    sorted.add(found < 0 ? -found - 1 : found, measurement);
  }

  /** Whether there are as many measurements as there are to be. */
  public boolean checkSize() {
    return sorted.size() == size;
  }

  /**
   * The median; all measurements are forgotten.
   *
   * @throws IndexOutOfBoundsException if there are not enough of them
   */
  public double getMedian() {
    double median = sorted.get(size / 2);
    sorted.clear();
    return median;
  }

  /** The measurements, sorted. */
  @Override
  public String toString() {
    return sorted.toString();
  }
}

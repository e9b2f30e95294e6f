package org.urbi.sim.vision;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.urbi.sim.SimulationException;
import org.urbi.sim.render.Colour;

/**
 * Maps each pixel to a named colour. Where colour ranges overlap, the one that was defined last
 * counts.
 */
public final class ColourMap {
  private static final int MAX = 255;

  private record Entry(ColourRange range, Colour shown) {}

  private final SequencedMap<String, Entry> entries = new LinkedHashMap<>();
  private final ColourMask mask;

  /**
   * @throws SimulationException if OpenCV cannot be used
   */
  public ColourMap() {
    OpenCv.require();
    mask = new ColourMask();
  }

  /**
   * Names a colour.
   *
   * @param shown how {@link #paint} shows it
   */
  public void define(String name, ColourRange range, Colour shown) {
    if (entries.size() == MAX && !entries.containsKey(name)) {
      throw new SimulationException("more than " + MAX + " colours");
    }
    entries.put(name, new Entry(range, shown));
  }

  /** Forgets a name; false if it had none. */
  public boolean forget(String name) {
    return entries.remove(name) != null;
  }

  /** The names, as they were given. */
  public List<String> names() {
    return new ArrayList<>(entries.keySet());
  }

  /**
   * For each pixel the number of its colour, from 1, in the order of {@link #names}; 0 for none.
   */
  public byte[] classify(byte[] rgb, int width, int height) {
    Mat image = OpenCv.matrix(rgb, width, height);
    Mat classes = new Mat(height, width, CvType.CV_8UC1, Scalar.all(0));
    mask.prepare(image);
    int number = 0;
    for (Entry entry : entries.values()) {
      classes.setTo(Scalar.all(++number), mask.select(entry.range()));
    }
    byte[] bytes = OpenCv.bytes(classes);
    image.release();
    classes.release();
    return bytes;
  }

  /** The share of each colour in the image, from 0 to 1. */
  public Map<String, Double> shares(byte[] rgb, int width, int height) {
    int[] counts = new int[MAX + 1];
    for (byte each : classify(rgb, width, height)) {
      counts[each & 255]++;
    }
    Map<String, Double> shares = new LinkedHashMap<>();
    int number = 0;
    for (String name : entries.keySet()) {
      shares.put(name, counts[++number] / ((double) width * height));
    }
    return shares;
  }

  /** The image with each pixel in the colour that stands for its own; black for none. */
  public byte[] paint(byte[] rgb, int width, int height) {
    Mat image = OpenCv.matrix(rgb, width, height);
    Mat painted = new Mat(height, width, CvType.CV_8UC3, Scalar.all(0));
    mask.prepare(image);
    for (Entry entry : entries.values()) {
      Colour c = entry.shown();
      painted.setTo(
          new Scalar(255 * c.red(), 255 * c.green(), 255 * c.blue()), mask.select(entry.range()));
    }
    byte[] bytes = OpenCv.bytes(painted);
    image.release();
    painted.release();
    return bytes;
  }
}

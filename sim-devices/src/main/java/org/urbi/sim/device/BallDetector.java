package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.vision.Blob;
import org.urbi.sim.vision.BlobFinder;
import org.urbi.sim.vision.ColourRange;
import urbi.UImage;
import urbi.UStart;
import urbi.UVar;

/**
 * Finds a ball in the images of a camera, {@code new("camera.val")} (manual, "Writing a Softdevice:
 * Ball Detection", and interface BlobDetector): the largest patch of a colour. {@code x} and {@code
 * y} go from -0.5 to 0.5, to the right and upwards. They stay as they were while nothing is {@code
 * visible}.
 */
@UStart
public final class BallDetector extends ImageConsumer {
  private static final double STANDARD_THRESHOLD = 0.0002;

  private final UVar visible = new UVar();
  private final UVar x = new UVar();
  private final UVar y = new UVar();
  private final UVar ratio = new UVar();
  private final UVar threshold = new UVar();
  private final UVar elongation = new UVar();
  private final UVar orientation = new UVar();
  private @Nullable BlobFinder finder;
  private ColourRange colour = ColourRange.RED;
  private @Nullable Blob last;

  public BallDetector(String name) {
    super(name);
  }

  @Override
  void bind() {
    finder = new BlobFinder();
    UBindVars(
        visible,
        "visible",
        x,
        "x",
        y,
        "y",
        ratio,
        "ratio",
        threshold,
        "threshold",
        elongation,
        "elongation",
        orientation,
        "orientation");
    visible.setValue(0);
    for (UVar each : new UVar[] {x, y, ratio, elongation, orientation}) {
      each.setValue(0);
    }
    threshold.setValue(STANDARD_THRESHOLD);
    UBindFunction("setColour");
  }

  /** Which colour the ball has: hue in degrees, from 0 to 360, saturation and value from 0 to 1. */
  public void setColour(
      double minHue,
      double maxHue,
      double minSaturation,
      double maxSaturation,
      double minValue,
      double maxValue) {
    colour = new ColourRange(minHue, maxHue, minSaturation, maxSaturation, minValue, maxValue);
  }

  /** What it has found in the last image; null if nothing. */
  @Nullable Blob last() {
    return last;
  }

  @Override
  void process(UImage rgb) {
    double least = SimulationException.finite(threshold.doubleValue(), "threshold");
    Blob blob =
        ready(finder)
            .find(rgb.getData(), rgb.getWidth(), rgb.getHeight(), colour, least)
            .orElse(null);
    last = blob;
    if (blob != null) {
      x.setValue(blob.x());
      y.setValue(blob.y());
      elongation.setValue(blob.elongation());
      orientation.setValue(blob.orientation());
    }
    ratio.setValue(blob == null ? 0 : blob.ratio());
    visible.setValue(blob == null ? 0 : 1);
  }
}

package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.render.Colour;
import org.urbi.sim.vision.ColourMap;
import org.urbi.sim.vision.ColourRange;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UStart;
import urbi.UVar;

/**
 * Tells colours that have names apart in the images of a camera, {@code new("camera.val")}: {@code
 * shares} has the share of each in the image, {@code val} is the image painted in them.
 */
@UStart
public final class ColourMapper extends ImageConsumer {
  private final UVar val = new UVar();
  private final UVar shares = new UVar();
  private @Nullable ColourMap map;

  public ColourMapper(String name) {
    super(name);
  }

  @Override
  void bind() {
    map = new ColourMap();
    UBindVars(val, "val", shares, "shares");
    shares.setValue((Object) Map.of());
    UBindFunctions("define", "forget", "names");
  }

  /**
   * Names a colour: hue in degrees, saturation and value from 0 to 1, and how it is painted: red,
   * green and blue from 0 to 1.
   */
  public void define(
      String name,
      double minHue,
      double maxHue,
      double minSaturation,
      double maxSaturation,
      double minValue,
      double maxValue,
      double red,
      double green,
      double blue) {
    ready(map)
        .define(
            name,
            new ColourRange(minHue, maxHue, minSaturation, maxSaturation, minValue, maxValue),
            new Colour(red, green, blue));
  }

  /** Forgets a name; false if it had none. */
  public boolean forget(String name) {
    return ready(map).forget(name);
  }

  /** The names, as they were given. */
  public List<String> names() {
    return ready(map).names();
  }

  @Override
  void process(UImage rgb) {
    int width = rgb.getWidth();
    int height = rgb.getHeight();
    shares.setValue((Object) ready(map).shares(rgb.getData(), width, height));
    val.setValue(
        new UImage(
            UImageFormat.IMAGE_RGB, width, height, ready(map).paint(rgb.getData(), width, height)));
  }
}

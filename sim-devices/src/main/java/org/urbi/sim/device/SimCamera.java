package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.render.Lens;
import org.urbi.sim.vision.ImageCoder;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UStart;
import urbi.UVar;

/**
 * A camera (manual, interface VideoIn): {@code val} is the image, in the {@code format} that is an
 * index of {@link UImageFormat}, {@code quality} that of JPEG. {@code resolution} 0 is the size of
 * the world file, each further one half of that before. It renders when somebody reads {@code val},
 * and {@code rate} times a second for those who wait for its changes; 0 for not at all.
 */
@UStart
public final class SimCamera extends SimDevice {
  /** A camera has as many resolutions. */
  private static final int RESOLUTIONS = 4;

  private static final double STANDARD_RATE = 10;
  private static final int STANDARD_QUALITY = 85;

  private final UVar val = new UVar();
  private final UVar width = new UVar();
  private final UVar height = new UVar();
  private final UVar xfov = new UVar();
  private final UVar yfov = new UVar();
  private final UVar resolution = new UVar();
  private final UVar format = new UVar();
  private final UVar quality = new UVar();
  private final UVar rate = new UVar();
  private Mount.@Nullable Camera full;
  private Mount.@Nullable Camera current;
  private UImageFormat imageFormat = UImageFormat.IMAGE_RGB;
  private int usedResolution;
  private int usedQuality = STANDARD_QUALITY;
  private double usedRate = STANDARD_RATE;
  private long taken = -1;
  private double lastTime = Double.NEGATIVE_INFINITY;

  public SimCamera(String name) {
    super(name);
  }

  @Override
  void bind(SimulatedWorld world, String deviceName) {
    full = world.mount(Mount.Camera.class, deviceName);
    UBindVars(
        val,
        "val",
        width,
        "width",
        height,
        "height",
        xfov,
        "xfov",
        yfov,
        "yfov",
        resolution,
        "resolution",
        format,
        "format",
        quality,
        "quality",
        rate,
        "rate");
    xfov.setValue(ready(full).lens().xfov());
    yfov.setValue(ready(full).lens().yfov());
    use(0);
    resolution.setValue(0);
    format.setValue(imageFormat.ordinal());
    quality.setValue(usedQuality);
    rate.setValue(usedRate);
    UNotifyAccess(val, "take");
    UNotifyChange(resolution, "resolutionChanged");
    UNotifyChange(format, "formatChanged");
    UNotifyChange(quality, "qualityChanged");
    UNotifyChange(rate, "rateChanged");
  }

  /** Where it is, and how it projects. */
  Mount.Camera mount() {
    return ready(current);
  }

  private void use(int index) {
    Mount.Camera whole = ready(full);
    Lens lens = whole.lens();
    Lens smaller =
        lens.resized(Math.max(1, lens.width() >> index), Math.max(1, lens.height() >> index));
    current = new Mount.Camera(whole.name(), whole.body(), whole.pose(), smaller);
    width.setValue(smaller.width());
    height.setValue(smaller.height());
    usedResolution = index;
    taken = -1;
  }

  /** Another resolution. */
  public void resolutionChanged() {
    int index = resolution.intValue();
    if (index < 0 || index >= RESOLUTIONS) {
      throw refused(resolution, usedResolution, "resolution: between 0 and " + (RESOLUTIONS - 1));
    }
    use(index);
  }

  /** Has a slot keep what it had; what it was given is not changed in silence. */
  private SimulationException refused(UVar slot, double former, String expected) {
    String given = slot.getUValue().toString();
    slot.setValue(former);
    return new SimulationException(
        ready(full).name() + ": " + expected + " expected, not " + given);
  }

  /** Another format. */
  public void formatChanged() {
    UImageFormat[] all = UImageFormat.values();
    int index = format.intValue();
    if (index <= 0 || index >= all.length) {
      throw refused(
          format,
          imageFormat.ordinal(),
          "format: one of "
              + String.join(
                  ", ",
                  Arrays.stream(all)
                      .skip(1)
                      .map(f -> f.ordinal() + " (" + f.format_string() + ")")
                      .toList()));
    }
    imageFormat = all[index];
    taken = -1;
  }

  /** Another quality of JPEG. */
  public void qualityChanged() {
    if (!(quality.doubleValue() >= 0 && quality.doubleValue() <= 100)) {
      throw refused(quality, usedQuality, "quality: between 0 and 100");
    }
    usedQuality = quality.intValue();
    taken = -1;
  }

  /** Another rate. */
  public void rateChanged() {
    if (!(rate.doubleValue() >= 0 && rate.doubleValue() <= 1000)) {
      throw refused(rate, usedRate, "rate: between 0 and 1000");
    }
    usedRate = rate.doubleValue();
  }

  /** Somebody wants to see: renders, unless nothing has moved since. */
  public void take() {
    catchUp();
    long step = world().physics().steps();
    if (step == taken) {
      return;
    }
    taken = step;
    lastTime = world().physics().time();
    Lens lens = mount().lens();
    UImage image =
        ImageCoder.encode(
            world().render(mount()), lens.width(), lens.height(), imageFormat, usedQuality);
    val.setValue(image);
  }

  @Override
  void updateSensors() {
    if (usedRate > 0 && world().physics().time() >= lastTime + 1 / usedRate - 1e-9) {
      take();
    }
  }
}

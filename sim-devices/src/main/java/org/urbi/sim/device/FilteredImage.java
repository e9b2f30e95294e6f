package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.vision.ImageFilter;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UStart;
import urbi.UVar;

/**
 * The images of a camera, {@code ImageFilter.new("camera.val")}, filtered: {@code val}. {@code
 * kind} names the filter, {@code parameter} is what that kind needs; {@code kinds} lists all.
 */
@UStart("ImageFilter")
public final class FilteredImage extends ImageConsumer {
  private final UVar val = new UVar();
  private final UVar kind = new UVar();
  private final UVar parameter = new UVar();
  private @Nullable ImageFilter filter;

  public FilteredImage(String name) {
    super(name);
  }

  @Override
  void bind() {
    filter = new ImageFilter(ImageFilter.Kind.GREY);
    UBindVars(val, "val", kind, "kind", parameter, "parameter");
    UBindFunction("kinds");
    kind.setValue(ImageFilter.Kind.GREY.urbiName());
    parameter.setValue(0);
    UNotifyChange(kind, "kindChanged");
    UNotifyChange(parameter, "parameterChanged");
  }

  /** The names of all kinds. */
  public List<String> kinds() {
    return ImageFilter.Kind.names();
  }

  /** Another kind, with its usual parameter. */
  public void kindChanged() {
    filter = new ImageFilter(ImageFilter.Kind.named(kind.stringValue()));
    parameter.setValue(ready(filter).parameter());
  }

  /** Another parameter. */
  public void parameterChanged() {
    ready(filter).setParameter(parameter.doubleValue());
  }

  @Override
  void process(UImage rgb) {
    byte[] filtered = ready(filter).apply(rgb.getData(), rgb.getWidth(), rgb.getHeight());
    val.setValue(new UImage(UImageFormat.IMAGE_RGB, rgb.getWidth(), rgb.getHeight(), filtered));
  }
}

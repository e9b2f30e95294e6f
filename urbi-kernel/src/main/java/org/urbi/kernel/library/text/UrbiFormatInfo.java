package org.urbi.kernel.library.text;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A format, such as {@code %6.3f} (manual, "FormatInfo"). */
public final class UrbiFormatInfo extends UrbiObject {
  /**
   * The parts of a format.
   *
   * @param alignment -1 for left, 0 for centered, 1 for right
   * @param alternate whether the base and the decimal point are always shown
   * @param group what separates thousands
   * @param prefix what comes before positive numbers
   * @param precision -1 when it is not given
   * @param spec the conversion, in lower case
   * @param uppercase 1, or -1 for lower case, or 0
   */
  record Format(
      String pattern,
      int alignment,
      boolean alternate,
      String group,
      char pad,
      String prefix,
      int width,
      int precision,
      char spec,
      int uppercase) {
    static final Format DEFAULT = new Format("%s", 1, false, "", ' ', "", 0, -1, 's', 0);

    int precisionOrDefault() {
      return precision < 0 ? 6 : precision;
    }
  }

  private Format format;

  UrbiFormatInfo(Shape shape, Format format) {
    super(shape);
    this.format = format;
  }

  Format format() {
    return format;
  }

  void setFormat(Format other) {
    format = other;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiFormatInfo(cloneShape(), format);
  }
}

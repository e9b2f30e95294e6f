package urbi;

/** A property of a variable (manual, "Using urbi variables"): {@code v.rangemin.setValue(0)}. */
public final class UProp {
  private final UVar owner;
  private final UProperty property;

  UProp(UVar owner, UProperty property) {
    this.owner = owner;
    this.property = property;
  }

  /** The value; void if the variable has no such property. */
  public UValue getUValue() {
    return owner.getProp(property);
  }

  /**
   * The value as a number.
   *
   * @throws UCastException if it is none
   */
  public double doubleValue() {
    return getUValue().doubleValue();
  }

  /**
   * The value as a string.
   *
   * @throws UCastException if it is none
   */
  public String stringValue() {
    return getUValue().stringValue();
  }

  public void setValue(UValue value) {
    owner.setProp(property, value);
  }

  public void setValue(double value) {
    setValue(new UValue(value));
  }

  public void setValue(String value) {
    setValue(new UValue(value));
  }

  /** A mode of blending, for {@link UVar#blend}. */
  public void setValue(UBlendType value) {
    setValue(new UValue(value.text()));
  }

  @Override
  public String toString() {
    return owner.getName() + "->" + property.text();
  }
}

package urbi;

/** The properties of a variable that a {@link UVar} gives access to (manual, "Properties"). */
public enum UProperty {
  /** The least value; writing less writes this. */
  PROP_RANGEMIN("rangemin"),
  /** The greatest value; writing more writes this. */
  PROP_RANGEMAX("rangemax"),
  /** The least speed of a motion, in units per second. */
  PROP_SPEEDMIN("speedmin"),
  /** The greatest speed of a motion, in units per second. */
  PROP_SPEEDMAX("speedmax"),
  /** What becomes of several assignments at a time, see {@link UBlendType}. */
  PROP_BLEND("blend"),
  /** How near its target an adaptive motion at a speed is over. */
  PROP_DELTA("delta"),
  /** Not 0 if the variable may not be assigned. */
  PROP_CONSTANT("constant");

  private final String text;

  UProperty(String text) {
    this.text = text;
  }

  /** The name of the property in urbiscript. */
  public String text() {
    return text;
  }
}

package urbi;

/** The properties of a variable that a {@link UVar} gives access to (manual, "Properties"). */
public enum UProperty {
  PROP_RANGEMIN("rangemin"),
  PROP_RANGEMAX("rangemax"),
  PROP_SPEEDMIN("speedmin"),
  PROP_SPEEDMAX("speedmax"),
  PROP_BLEND("blend"),
  PROP_DELTA("delta"),
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

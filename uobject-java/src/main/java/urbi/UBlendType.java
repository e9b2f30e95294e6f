package urbi;

/** What becomes of several assignments at a time to one variable (manual, "Properties"). */
public enum UBlendType {
  UNORMAL("normal"),
  UMIX("mix"),
  UADD("add"),
  UDISCARD("discard"),
  UQUEUE("queue"),
  UCANCEL("cancel");

  private final String text;

  UBlendType(String text) {
    this.text = text;
  }

  /** The value of the property {@code blend} in urbiscript. */
  public String text() {
    return text;
  }
}

package urbi;

/** How simultaneous assignments to one variable are combined (manual, "Properties"). */
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

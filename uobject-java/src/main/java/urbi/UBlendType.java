package urbi;

/** How simultaneous assignments to one variable are combined (manual, "Properties"). */
public enum UBlendType {
  /** The last assignment counts. */
  UNORMAL("normal"),
  /** The value is the mean of what is assigned at a time. */
  UMIX("mix"),
  /** The value is the sum of what is assigned at a time. */
  UADD("add"),
  /** Assignments are dropped while another one goes on. */
  UDISCARD("discard"),
  /** An assignment waits until those before it are over. */
  UQUEUE("queue"),
  /** An assignment ends those that go on. */
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

package org.urbi.kernel.object;

/** Raw memory with a header (manual, "Binary"). */
public final class UrbiBinary extends UrbiObject {
  private String keywords;
  private String data;

  /**
   * @param data one character for each byte
   */
  public UrbiBinary(Shape shape, String keywords, String data) {
    super(shape);
    this.keywords = keywords;
    this.data = data;
  }

  public String keywords() {
    noteContentRead();
    return keywords;
  }

  public void setKeywords(String other) {
    keywords = other;
    noteContentChange();
  }

  /** The bytes, one in each character. */
  public String data() {
    noteContentRead();
    return data;
  }

  public void setData(String other) {
    data = other;
    noteContentChange();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiBinary(cloneShape(), keywords, data);
  }
}

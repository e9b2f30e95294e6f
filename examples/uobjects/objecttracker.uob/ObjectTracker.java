import urbi.UImage;
import urbi.UObject;
import urbi.UVar;

/** Follows what is not grey: {@code ObjectTracker.new(camera.&val)} is given its source. */
public class ObjectTracker extends UObject {
  static {
    UStart(ObjectTracker.class);
  }

  private static final int BYTES_PER_PIXEL = 3;

  private final UVar val = new UVar();

  public ObjectTracker(String name) {
    super(name);
    UBindFunction("init");
  }

  public void init(UVar image) {
    UBindVar(val, "val");
    val.setValue(-1);
    UNotifyChange(image, "onImage");
  }

  /** Puts the leftmost column that has a colour into {@code val}, or -1. */
  public void onImage(UVar source) {
    UImage image = source.uimageValue();
    byte[] data = image.getData();
    int leftmost = -1;
    for (int pixel = 0; pixel < image.getWidth() * image.getHeight(); pixel++) {
      int at = pixel * BYTES_PER_PIXEL;
      int column = pixel % image.getWidth();
      if (data[at] != data[at + 1] && (leftmost < 0 || column < leftmost)) {
        leftmost = column;
      }
    }
    val.setValue(leftmost);
  }
}

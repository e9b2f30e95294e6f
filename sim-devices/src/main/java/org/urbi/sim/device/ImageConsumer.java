package org.urbi.sim.device;

import org.urbi.sim.vision.ImageCoder;
import urbi.UImage;
import urbi.UObject;
import urbi.UVar;

/** Something that works on each new image of a variable: {@code new("camera.val")}. */
abstract class ImageConsumer extends UObject {
  ImageConsumer(String name) {
    super(name);
    UBindFunction("init");
  }

  /** Begins to work on the images of a variable. */
  public final void init(String imageVariable) {
    bind();
    UNotifyChange(imageVariable, "newImage");
  }

  /** Binds what urbiscript sees of it. */
  abstract void bind();

  /** A new image. */
  public final void newImage(UVar image) {
    process(ImageCoder.toRgb(image.uimageValue()));
  }

  /** Works on an image of red, green and blue. */
  abstract void process(UImage rgb);
}

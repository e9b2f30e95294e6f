package org.urbi.sim.page;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.group.ChannelGroup;
import io.netty.channel.group.ChannelMatcher;
import io.netty.channel.group.DefaultChannelGroup;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.util.concurrent.EventExecutor;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.vision.ImageCoder;
import urbi.Log;
import urbi.UConversionException;
import urbi.UImage;
import urbi.UImageFormat;

/**
 * The connected browsers, and what they are sent: the world description, then snapshots (text).
 * Each new camera image (a JPEG file) follows the first snapshot that contains it. Everything but
 * {@link #isWaiting}, {@link #show} and {@link #describe} is done on the page's thread, also for
 * those who look by way of another page.
 */
final class Viewers {
  /** Moments in a second, at most. */
  private static final int RATE = 30;

  private static final int QUALITY = 80;

  private final EventExecutor thread;
  private final ChannelGroup viewers;
  private final AtomicBoolean waiting = new AtomicBoolean();
  private volatile String setting;
  private @Nullable String moment;
  private byte @Nullable [] image;
  private long imageNumber;

  /** The last failure that has been logged. */
  private @Nullable String logged;

  Viewers(EventExecutor thread, String setting) {
    this.thread = thread;
    this.setting = setting;
    viewers = new DefaultChannelGroup(thread);
  }

  /**
   * Asks for a moment now and then, as long as somebody looks; what was missed is not made up for.
   */
  void start() {
    thread.scheduleWithFixedDelay(
        () -> waiting.set(!viewers.isEmpty()), 0, 1000 / RATE, TimeUnit.MILLISECONDS);
  }

  int count() {
    return viewers.size();
  }

  boolean isWaiting() {
    return waiting.get();
  }

  /** By what a browser is known. */
  static String name(Channel viewer) {
    return viewer.id().asShortText();
  }

  /** Tells one browser something for people, if it is still there. */
  void tell(String viewer, String text) {
    execute(() ->
        viewers.writeAndFlush(
            refusal(text), each -> name(each).equals(viewer) && each.isWritable()));
  }

  /** Why something was not done. */
  static TextWebSocketFrame refusal(String text) {
    return told("refusal", text);
  }

  /** Something for people, or for the page. */
  static TextWebSocketFrame told(String type, String text) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("type", type);
    all.put("text", text);
    return new TextWebSocketFrame(Json.text(all));
  }

  /** A browser looks from now on; it is sent what there is. */
  void add(Channel viewer) {
    execute(() -> welcome(viewer));
  }

  private void welcome(Channel viewer) {
    viewers.add(viewer);
    viewer.write(new TextWebSocketFrame(setting));
    if (moment != null) {
      viewer.write(new TextWebSocketFrame(moment));
    }
    if (image != null) {
      viewer.write(new BinaryWebSocketFrame(Unpooled.wrappedBuffer(image)));
    }
    viewer.flush();
  }

  void show(Snapshot next) {
    waiting.set(false);
    execute(() -> send(next));
  }

  void describe(String other) {
    setting = other;
    execute(() -> {
      moment = null;
      image = null;
      viewers.writeAndFlush(new TextWebSocketFrame(other));
    });
  }

  /** Says goodbye to those who look by way of another page, whose port stays. */
  void close() {
    ChannelMatcher elsewhere = viewer -> viewer.eventLoop() != thread;
    CloseWebSocketFrame end = new CloseWebSocketFrame(WebSocketCloseStatus.ENDPOINT_UNAVAILABLE);
    viewers.writeAndFlush(end, elsewhere);
    viewers.close(elsewhere);
  }

  private void execute(Runnable work) {
    try {
      thread.execute(work);
    } catch (RejectedExecutionException e) {
      // The page has been closed: there is nobody to show it to.
    }
  }

  private void send(Snapshot next) {
    moment = next.json();
    byte[] fresh = freshImage(next.sight());
    for (Channel viewer : viewers) {
      if (viewer.isWritable()) {
        viewer.write(new TextWebSocketFrame(moment));
        if (fresh != null) {
          viewer.write(new BinaryWebSocketFrame(Unpooled.wrappedBuffer(fresh)));
        }
        viewer.flush();
      }
    }
  }

  /** The image of a moment as a file, if it is another one than that of the moment before. */
  private byte @Nullable [] freshImage(Snapshot.@Nullable CameraView sight) {
    if (sight == null || sight.image() == null || sight.number() == imageNumber) {
      return null;
    }
    imageNumber = sight.number();
    try {
      image = jpeg(sight.image());
      return image;
    } catch (RuntimeException e) {
      // An image of a variable may be anything; whoever looks is told, and the page goes on.
      logDefect(e);
      viewers.writeAndFlush(told("trouble", "no image: " + String.valueOf(e.getMessage())));
      return null;
    }
  }

  /** Thirty images a second may meet the same bug, which is logged once. */
  private void logDefect(RuntimeException failure) {
    boolean isOfTheImage =
        failure instanceof IllegalArgumentException
            || failure instanceof IllegalStateException
            || failure instanceof UConversionException;
    if (!isOfTheImage && !failure.toString().equals(logged)) {
      logged = failure.toString();
      Log.error("internal error in the coding of an image for browsers", failure);
    }
  }

  private static byte[] jpeg(UImage image) {
    if (image.getImageFormat() == UImageFormat.IMAGE_JPEG) {
      return image.getData();
    }
    UImage rgb = ImageCoder.toRgb(image);
    return ImageCoder.encode(
            rgb.getData(), rgb.getWidth(), rgb.getHeight(), UImageFormat.IMAGE_JPEG, QUALITY)
        .getData();
  }
}

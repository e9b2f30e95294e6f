package urbi.spi;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.classfile.Attributes;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.constantpool.MemberRefEntry;
import java.lang.classfile.constantpool.PoolEntry;
import java.util.List;
import java.util.Optional;
import java.util.jar.Manifest;
import org.jspecify.annotations.Nullable;
import urbi.UObject;
import urbi.UStart;

/**
 * Finds the classes of a jar that declare UObjects: those that call {@link UObject#UStart} or a
 * similar method, or are annotated with {@link UStart}. {@code umake-java} writes their names into
 * the manifest, so that they need not be searched for when the jar is loaded.
 */
public final class ModuleIndex {
  /** The attribute of the manifest: names of classes, with blanks between them. */
  public static final String ATTRIBUTE = "Urbi-UObjects";

  private static final List<String> STARTERS = List.of("UStart", "UStartRename", "UStartHub");
  private static final String ANNOTATION = "Lurbi/UStart;";

  private ModuleIndex() {}

  /**
   * Whether a class declares UObjects.
   *
   * @throws IllegalArgumentException if the bytes are no class file
   */
  public static boolean declares(byte @Nullable [] classFile) {
    ClassModel model = ClassFile.of().parse(classFile);
    for (PoolEntry entry : model.constantPool()) {
      if (entry instanceof MemberRefEntry member
          && STARTERS.contains(member.name().stringValue())) {
        return true;
      }
    }
    return model
        .findAttribute(Attributes.runtimeVisibleAnnotations())
        .map(all ->
            all.annotations().stream()
                .anyMatch(annotation -> annotation.className().equalsString(ANNOTATION)))
        .orElse(false);
  }

  /** The names in a manifest; nothing if it has no index, or there is no manifest (null). */
  static Optional<List<String>> read(byte @Nullable [] manifest) {
    if (manifest == null) {
      return Optional.empty();
    }
    try {
      String names =
          new Manifest(new ByteArrayInputStream(manifest)).getMainAttributes().getValue(ATTRIBUTE);
      return Optional.ofNullable(names)
          .map(text -> text.isBlank() ? List.of() : List.of(text.strip().split("\\s+")));
    } catch (IOException e) {
      // A manifest that cannot be read has no index; whatever else it says does not matter here.
      return Optional.empty();
    }
  }
}

package org.urbi.builtins;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.annotation.processing.AbstractProcessor;
import javax.annotation.processing.RoundEnvironment;
import javax.annotation.processing.SupportedAnnotationTypes;
import javax.annotation.processing.SupportedOptions;
import javax.lang.model.SourceVersion;
import javax.lang.model.element.Element;
import javax.lang.model.element.TypeElement;
import javax.tools.Diagnostic;

/**
 * Checks the classes of builtins and writes their tables, and the list of all tables. Invalid
 * declarations are compilation errors at their location; so is a builtin without an example in the
 * {@linkplain ReferenceTexts reference}.
 */
@SupportedAnnotationTypes("org.urbi.builtins.*")
@SupportedOptions(ReferenceTexts.OPTION)
public final class BuiltinProcessor extends AbstractProcessor {
  private final List<Declaration> all = new ArrayList<>();
  private final Map<String, Element> declared = new HashMap<>();

  @Override
  public SourceVersion getSupportedSourceVersion() {
    return SourceVersion.latestSupported();
  }

  @Override
  public boolean process(Set<? extends TypeElement> annotations, RoundEnvironment round) {
    List<Declaration> found = new ArrayList<>();
    var texts = new ReferenceTexts(processingEnv.getOptions().get(ReferenceTexts.OPTION));
    var reader = new DeclarationReader(processingEnv, declared, texts);
    for (Element e : round.getElementsAnnotatedWith(UrbiType.class)) {
      read(reader, (TypeElement) e, found);
    }
    for (Element e : round.getElementsAnnotatedWith(UrbiTypePart.class)) {
      read(reader, (TypeElement) e, found);
    }
    for (Element e : round.getElementsAnnotatedWith(Builtin.class)) {
      Element owner = e.getEnclosingElement();
      if (owner == null
          || owner.getAnnotation(UrbiType.class) == null
              && owner.getAnnotation(UrbiTypePart.class) == null) {
        error(e, "@Builtin outside a class with @UrbiType or @UrbiTypePart");
      }
    }
    if (found.isEmpty() || round.errorRaised()) {
      return false;
    }
    all.addAll(found);
    checkParts();
    all.sort(
        Comparator.comparing((Declaration d) -> d.type)
            .thenComparing(Declaration::isPart)
            .thenComparing(d -> d.className));
    for (Declaration type : found) {
      write(type.packageName + "." + type.tableName(), TableWriter.table(type));
    }
    write(
        KernelClassNames.INDEX_PACKAGE + "." + KernelClassNames.INDEX_NAME, TableWriter.index(all));
    return false;
  }

  private static void read(DeclarationReader reader, TypeElement type, List<Declaration> found) {
    Declaration declaration = reader.read(type);
    if (declaration != null) {
      found.add(declaration);
    }
  }

  private void checkParts() {
    for (Declaration part : all) {
      if (part.isPart() && all.stream().noneMatch(d -> !d.isPart() && d.type.equals(part.type))) {
        error(
            processingEnv.getElementUtils().getTypeElement(part.packageName + "." + part.className),
            "no class declares the type " + part.type);
      }
    }
  }

  private void write(String name, String source) {
    try (Writer writer = processingEnv.getFiler().createSourceFile(name).openWriter()) {
      writer.write(source);
    } catch (IOException e) {
      processingEnv
          .getMessager()
          .printMessage(Diagnostic.Kind.ERROR, "cannot write " + name + ": " + e.getMessage());
    }
  }

  private void error(Element at, String message) {
    processingEnv.getMessager().printMessage(Diagnostic.Kind.ERROR, message, at);
  }
}

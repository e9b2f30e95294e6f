package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;

/** Whether people who do not see well, or have nothing but keys, can use a page as it is now. */
final class Accessibility {
  /**
   * Finds what is wrong, in lines: controls without a name, or with one that whoever speaks to the
   * machine cannot read on them; parts of the page with the same name; text that is hard to read.
   */
  private static final String FAULTS =
      """
      const faults = new Set();
      const seen = (element) => element.checkVisibility({opacityProperty: true, visibilityProperty: true});
      const shown = (element) => element.tagName.toLowerCase() + (element.id ? '#' + element.id : '.' + element.className);
      const text = (element) => element?.textContent.trim() ?? '';
      const name = (element) =>
        element.ariaLabel || text(document.getElementById(element.getAttribute('aria-labelledby')))
        || [...(element.labels ?? [])].map(text).join('')
        || (['INPUT', 'SELECT', 'TEXTAREA'].includes(element.tagName) ? '' : text(element)) || element.title;
      for (const element of document.querySelectorAll('button, select, input, textarea, a[href], [tabindex], iframe')) {
        if (seen(element) && !name(element)) faults.add(shown(element) + ' has no name');
        if (element.tabIndex > 0) faults.add(shown(element) + ' is out of order for Tab');
      }
      const plain = (words) => words.toLowerCase().replace(/[^\\p{L}\\p{N}]+/gu, '');
      for (const element of document.querySelectorAll('button, [role=treeitem]')) {
        const label = element.ariaLabel && seen(element) ? element.innerText : '';
        if (!plain(name(element)).includes(plain(label))) {
          faults.add('"' + label + '" is not in the name of ' + shown(element) + ': ' + name(element));
        }
      }
      const landmarks = new Set();
      for (const element of document.querySelectorAll('[role=region], section, form')) {
        const called = element.ariaLabel || text(document.getElementById(element.getAttribute('aria-labelledby')));
        const landmark = (element.tagName === 'FORM' ? 'form ' : 'region ') + called;
        if (!called || !seen(element)) continue;
        if (landmarks.has(landmark)) faults.add('two parts of the page are the ' + landmark);
        landmarks.add(landmark);
      }
      for (const element of document.querySelectorAll('[role=tree] [role]:not([role=treeitem], [role=group], [role=treeitem] *)')) {
        if (!element.closest('[aria-hidden=true]')) faults.add(shown(element) + ' is in a tree, and no item of it');
      }
      const pen = Object.assign(document.createElement('canvas'), {width: 1, height: 1}).getContext('2d', {willReadFrequently: true});
      const paint = (colours) => {
        pen.clearRect(0, 0, 1, 1);
        for (const colour of colours) { pen.fillStyle = colour; pen.fillRect(0, 0, 1, 1); }
        return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3);
      };
      const light = (colour) => {
        const [r, g, b] = colour.map((part) => part / 255).map((part) => part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const theme = document.documentElement.dataset.theme;
      for (const wanted of ['light', 'dark']) {
        document.documentElement.dataset.theme = wanted;
        // What lights up for a moment has faded.
        for (const animation of document.getAnimations()) animation.finish();
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (walker.nextNode()) {
          const element = walker.currentNode.parentElement;
          const words = walker.currentNode.data.trim();
          if (!words || !seen(element) || element.closest(':disabled, script, style, option, noscript')) continue;
          const behind = [];
          for (let each = element; each; each = each.parentElement) behind.unshift(getComputedStyle(each).backgroundColor);
          const style = getComputedStyle(element);
          const [a, b] = [light(paint(behind)), light(paint([...behind, style.color]))];
          const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
          const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.6 && style.fontWeight >= 700);
          if (contrast < (large ? 3 : 4.5)) faults.add(wanted + ': contrast ' + contrast.toFixed(2) + ' of "' + words.slice(0, 30) + '" in ' + shown(element));
        }
      }
      if (theme) document.documentElement.dataset.theme = theme;
      else delete document.documentElement.dataset.theme;
      return [...faults].join('\\n');
      """;

  private Accessibility() {}

  /** Nothing may be wrong, in light and in dark colours. */
  static void check(Browser browser) throws IOException {
    check(browser, "window.document");
  }

  /**
   * Likewise for a page within the page.
   *
   * @param document JavaScript: the document of it
   */
  static void check(Browser browser, String document) throws IOException {
    assertEquals("", browser.evaluate("const document = " + document + ";\n" + FAULTS));
  }
}

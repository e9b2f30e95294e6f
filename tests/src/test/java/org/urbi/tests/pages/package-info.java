/** The listings of the documentation, which run. */
@NullMarked
package org.urbi.tests.pages;

import org.jspecify.annotations.NullMarked;

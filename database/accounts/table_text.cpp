// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/table_text.h"

#include <algorithm>
#include <cctype>
#include <iconv.h>
#include <optional>
#include <string_view>

namespace chiron::database {
namespace {

using Kind = TextProblem::Kind;

unsigned char byteAt(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

int lineAt(std::string_view text, std::size_t at) {
    return 1 +
           static_cast<int>(std::count(
               text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
}

// Recognises files of other programs by their signature, which a list of people does not have.
std::optional<Kind> otherFile(std::string_view bytes) {
    if (bytes.starts_with("%PDF")) {
        return Kind::pdf;
    }
    if (bytes.starts_with("\xd0\xcf\x11\xe0")) {
        return Kind::oldExcel;
    }
    if (!bytes.starts_with("PK\x03\x04") && !bytes.starts_with("PK\x05\x06")) {
        return std::nullopt;
    }
    const std::string_view head = bytes.substr(0, 4096);
    if (head.find("opendocument.spreadsheet") != std::string_view::npos) {
        return Kind::openDocument;
    }
    const bool excel = head.find("[Content_Types].xml") != std::string_view::npos ||
                       bytes.find("xl/workbook") != std::string_view::npos;
    return excel ? Kind::excel : Kind::archive;
}

/// Converts to UTF-8; otherwise returns the position of the first invalid byte.
tl::expected<std::string, std::size_t> converted(const char* from, std::string_view bytes) {
    const iconv_t conversion = iconv_open("UTF-8", from);
    if (conversion == reinterpret_cast<iconv_t>(-1)) {
        return tl::unexpected(std::size_t{0});
    }
    std::string copy(bytes);
    std::string text(4 * bytes.size() + 4, '\0');
    char* in = copy.data();
    char* out = text.data();
    std::size_t inLeft = copy.size();
    std::size_t outLeft = text.size();
    const std::size_t done = iconv(conversion, &in, &inLeft, &out, &outLeft);
    iconv_close(conversion);
    if (done == static_cast<std::size_t>(-1) || inLeft > 0) {
        return tl::unexpected(bytes.size() - inLeft);
    }
    text.resize(text.size() - outLeft);
    return text;
}

/// Returns the length of the UTF-8 character that begins here, or 0 if none does.
std::size_t utf8Length(std::string_view bytes, std::size_t i) {
    const unsigned char first = byteAt(bytes, i);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0 || i + length > bytes.size()) {
        return 0;
    }
    for (std::size_t next = 1; next < length; ++next) {
        if ((byteAt(bytes, i + next) & 0xc0) != 0x80) {
            return 0;
        }
    }
    const unsigned char second = length > 1 ? byteAt(bytes, i + 1) : 0;
    const bool forbidden = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
                           (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
    return forbidden ? 0 : length;
}

struct Utf8Count {
    std::size_t good = 0; ///< valid characters of more than one byte
    std::size_t bad = 0;
    std::size_t firstBad = 0;
};

Utf8Count countUtf8(std::string_view bytes) {
    Utf8Count count;
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t length = utf8Length(bytes, i);
        count.good += length > 1 ? 1 : 0;
        if (length == 0 && count.bad++ == 0) {
            count.firstBad = i;
        }
        i += std::max<std::size_t>(length, 1);
    }
    return count;
}

/// Recognises UTF-16 without a byte order mark by its zero bytes, all at odd or all at even positions:
/// delimiters and line ends have them in every language.
const char* utf16Order(std::string_view bytes) {
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    }
    const std::size_t enough = std::max<std::size_t>(bytes.size() / 10, 2);
    return zeros[1] >= enough && zeros[0] == 0   ? "UTF-16LE"
           : zeros[0] >= enough && zeros[1] == 0 ? "UTF-16BE"
                                                 : nullptr;
}

/// Returns whether the text looks Greek. Greek words consist only of high bytes, while in Western European
/// languages an accented letter stands among plain ones.
bool looksGreek(std::string_view bytes) {
    const auto isHigh = [&](std::size_t i) { return i < bytes.size() && byteAt(bytes, i) >= 0xb8; };
    const auto isPlain = [&](std::size_t i) {
        return i < bytes.size() && std::isalpha(byteAt(bytes, i)) != 0 && byteAt(bytes, i) < 0x80;
    };
    int words = 0;
    int accents = 0;
    for (std::size_t i = 0; i < bytes.size();) {
        std::size_t end = i;
        while (isHigh(end)) {
            ++end;
        }
        words += end - i >= 3 ? 1 : 0;
        accents += end > i && end - i < 3 && ((i > 0 && isPlain(i - 1)) || isPlain(end)) ? 1 : 0;
        i = std::max(end, i + 1);
    }
    return words > 0 && words >= accents;
}

tl::expected<TableText, TextProblem> damaged(std::string_view bytes, std::size_t at) {
    return tl::unexpected(TextProblem{Kind::damaged, lineAt(bytes, at)});
}

tl::expected<TableText, TextProblem> fromUtf16(std::string_view bytes, const char* order) {
    const auto text = converted(order, bytes);
    if (text) {
        return TableText{*text, "UTF-16"};
    }
    const auto before = converted(order, bytes.substr(0, text.error()));
    return tl::unexpected(TextProblem{Kind::damaged, lineAt(before.value_or(""), std::string::npos)});
}

tl::expected<TableText, TextProblem> fromCodePage(std::string_view bytes) {
    const auto western = converted("CP1252", bytes);
    const auto greek = converted("CP1253", bytes);
    const bool useGreek = greek && (!western || looksGreek(bytes));
    if (useGreek) {
        return TableText{*greek, "Windows-1253"};
    }
    return western ? tl::expected<TableText, TextProblem>(TableText{*western, "Windows-1252"})
                   : damaged(bytes, std::max(western.error(), greek.error()));
}

tl::expected<TableText, TextProblem> decoded(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) {
        const Utf8Count count = countUtf8(bytes);
        return count.bad > 0 ? damaged(bytes, count.firstBad)
                             : TableText{std::string(bytes.substr(3)), "UTF-8"};
    }
    if (bytes.starts_with("\xff\xfe")) {
        return fromUtf16(bytes.substr(2), "UTF-16LE");
    }
    if (bytes.starts_with("\xfe\xff")) {
        return fromUtf16(bytes.substr(2), "UTF-16BE");
    }
    if (const char* order = utf16Order(bytes)) {
        return fromUtf16(bytes, order);
    }
    const Utf8Count count = countUtf8(bytes);
    if (count.bad == 0) {
        return TableText{std::string(bytes), "UTF-8"};
    }
    // Sequences of bytes rarely form UTF-8 characters by chance. If most of them are valid, the file is UTF-8
    // and something in it is damaged.
    return count.good >= count.bad ? damaged(bytes, count.firstBad) : fromCodePage(bytes);
}

} // namespace

tl::expected<TableText, TextProblem> readTableText(const std::string& bytes) {
    if (const auto other = otherFile(bytes)) {
        return tl::unexpected(TextProblem{*other, 1});
    }
    auto read = decoded(bytes);
    if (!read) {
        return read;
    }
    if (!read->text.empty() && read->text.back() == '\x1a') {
        read->text.pop_back(); // old programs mark the end of the text with this character
    }
    const auto control = std::find_if(read->text.begin(), read->text.end(), [](char c) {
        return c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r';
    });
    if (control != read->text.end()) {
        return tl::unexpected(TextProblem{
            Kind::binary, lineAt(read->text, static_cast<std::size_t>(control - read->text.begin()))});
    }
    return read;
}

} // namespace chiron::database

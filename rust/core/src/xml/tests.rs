use proptest::prelude::*;

use super::*;

/// Writes down what it is told.
#[derive(Default)]
struct Log(Vec<String>);

impl Handler for Log {
    fn start(&mut self, element: &Element<'_>) -> std::result::Result<(), String> {
        let [a, b] =
            [element.get("a"), element.get_in("urn:p", "b")].map(Option::unwrap_or_default);
        self.0.push(format!("{{{}}}{} a={a} b={b}", element.namespace, element.name));
        if element.name == "refused" { Err("makes no sense".into()) } else { Ok(()) }
    }

    fn end(&mut self, namespace: &str, name: &str) {
        self.0.push(format!("/{{{namespace}}}{name}"));
    }
}

/// Writes down texts alone.
#[derive(Default)]
struct Texts(Vec<String>);

impl Handler for Texts {
    fn start(&mut self, _: &Element<'_>) -> std::result::Result<(), String> {
        Ok(())
    }

    fn text(&mut self, text: &str) -> std::result::Result<(), String> {
        self.0.push(text.into());
        if text == "refused" { Err("makes no sense".into()) } else { Ok(()) }
    }

    fn end(&mut self, _: &str, _: &str) {}
}

#[test]
fn texts_come_with_their_references_resolved() {
    let document = "<a>\n <b>1 &lt; &#50;&amp;3</b><!-- none --> <c>ü<![CDATA[&lt;]]></c></a>";
    for length in [1, 5, document.len()] {
        let mut reader = Reader::new(Texts::default());
        document.as_bytes().chunks(length).try_for_each(|piece| reader.feed(piece)).unwrap();
        assert_eq!(reader.finish().unwrap().0, ["1 < 2&3", "ü", "&lt;"]);
    }
    let refused = Reader::new(Texts::default()).feed(b"<a>\n<b>refused</b>").unwrap_err();
    assert_eq!(refused.to_string(), "line 2: a text makes no sense");
}

fn read<'a>(pieces: impl IntoIterator<Item = &'a [u8]>) -> Result<Vec<String>> {
    let mut reader = Reader::new(Log::default());
    pieces.into_iter().try_for_each(|piece| reader.feed(piece))?;
    Ok(reader.finish()?.0)
}

fn complaint(text: &str) -> String {
    read([text.as_bytes()]).expect_err(text).to_string()
}

const DOCUMENT: &str = "\u{FEFF}<?xml version='1.0' encoding=\"UTF-8\" standalone='yes'?>\n\
    <!-- > ü - --><?hint a='<'?>\n\
    <m xmlns='urn:m' xmlns:p=\"urn:p\" a='&lt;&#x41;&#66;&amp;\"\n€' >text &gt; ü\r\n\
    <p:n p:b = \"1'&quot;>\" b='2'/><![CDATA[<&]]]]>\
    <o xmlns='' xmlns:p='urn:q' p:b='3'><p:o/></o ></m>\n<!---->\n ";

const EVENTS: [&str; 8] = [
    "{urn:m}m a=<AB&\" € b=",
    "{urn:p}n a= b=1'\">",
    "/{urn:p}n",
    "{}o a= b=",
    "{urn:q}o a= b=",
    "/{urn:q}o",
    "/{}o",
    "/{urn:m}m",
];

#[test]
fn elements_come_with_their_namespaces_and_attributes() {
    assert_eq!(read([DOCUMENT.as_bytes()]).unwrap(), EVENTS);
}

#[test]
fn utf_16_is_read_in_both_orders() {
    let text = DOCUMENT.replace("UTF-8", "utf-16").replace('€', "€\u{1F600}");
    let orders: [fn(u16) -> [u8; 2]; 2] = [u16::to_le_bytes, u16::to_be_bytes];
    for order in orders {
        let bytes: Vec<u8> = text.encode_utf16().flat_map(order).collect();
        for length in [1, 2, 3, 7, bytes.len()] {
            let events = read(bytes.chunks(length)).unwrap();
            assert_eq!(events[0], "{urn:m}m a=<AB&\" €\u{1F600} b=");
            assert_eq!(events[1..], EVENTS[1..]);
        }
    }
}

proptest! {
    #[test]
    fn it_does_not_matter_how_a_document_is_cut_into_pieces(
        cuts in prop::collection::vec(0..DOCUMENT.len(), 0..6)
    ) {
        let mut cuts = [vec![0, DOCUMENT.len()], cuts].concat();
        cuts.sort_unstable();
        let pieces = cuts.windows(2).map(|ends| &DOCUMENT.as_bytes()[ends[0]..ends[1]]);
        prop_assert_eq!(read(pieces).unwrap(), EVENTS);
    }

    #[test]
    fn bytes_of_any_kind_are_read_or_refused(
        mut bytes in Just(DOCUMENT.as_bytes().to_vec()),
        changes in prop::collection::vec((0..DOCUMENT.len(), any::<u8>()), 1..5),
    ) {
        for (place, byte) in changes {
            bytes[place] = byte;
        }
        let whole = read([bytes.as_slice()]).is_ok();
        prop_assert_eq!(read(bytes.chunks(1)).is_ok(), whole);
    }
}

#[test]
fn what_is_ill_formed_is_refused() {
    let ill_formed = [
        "",
        " ",
        "a",
        "<a>",
        "<a",
        "<a/><b/>",
        "<a/>b",
        "<a/></a>",
        "<a></b>",
        "<a b></a>",
        "<a b=c/>",
        "<a b='<'/>",
        "<a b='1'c='2'/>",
        "<a b='1' b='2'/>",
        "<a xmlns:p='u' xmlns:q='u' p:b='1' q:b='2'/>",
        "<a b='&x;'/>",
        "<a b='&'/>",
        "<a b='&#0;'/>",
        "<a b='&#xD800;'/>",
        "<a b='&#+65;'/>",
        "<a>&nbsp;</a>",
        "<a>]]></a>",
        "<a><!-- -- --></a>",
        "<a><![CDATA[</a>",
        "<![CDATA[]]><a/>",
        "<a><?xml version='1.0'?></a>",
        " <?xml version='1.0'?><a/>",
        "<?xml?><a/>",
        "<?xml encoding='UTF-8'?><a/>",
        "<?xml version='2.0'?><a/>",
        "<?xml version='1.0' encoding='latin1'?><a/>",
        "<?xml version='1.0' encoding='UTF-16'?><a/>",
        "<1/>",
        "< a/>",
        "<a/ >",
        "<:a/>",
        "<a:/>",
        "<a:b:c xmlns:a='u'/>",
        "<p:a/>",
        "<a p:b=''/>",
        "<a xmlns:p=''/>",
        "<a xmlns:xml='u'/>",
        "<a xmlns:xmlns='u'/>",
        "<a>\u{1}</a>",
        "<a>\u{FFFF}</a>",
    ];
    for text in ill_formed {
        let complaint = complaint(text);
        assert!(complaint.contains("damaged"), "{text}: {complaint}");
    }
    for bytes in [b"<a>\xFF</a>".as_slice(), b"<a>\xC3", b"\xFF\xFEa", b"\xFF\xFE<\0\0\xDC"] {
        assert!(read([bytes]).is_err());
    }
}

#[test]
fn a_fault_names_its_line() {
    assert!(complaint("<a>\n<b/>\n\n<c>\n</b></a>").starts_with("line 5: its XML is damaged"));
    let text = "<a>\n<b\n/><refused\n/></a>";
    assert_eq!(complaint(text), "line 3: a <refused> makes no sense");
    assert_eq!(read(text.as_bytes().chunks(1)).unwrap_err().to_string(), complaint(text));
}

#[test]
fn a_hostile_document_ends_early() {
    let deep = "<a>".repeat(MOST_DEEP + 1);
    let attributes: String = (0..=MOST_ATTRIBUTES).map(|i| format!(" a{i}=''")).collect();
    let bound: String = (0..MOST_ATTRIBUTES).map(|i| format!(" xmlns:a{i}='u'")).collect();
    let bindings = format!("<a{bound}>").repeat(MOST_BINDINGS / MOST_ATTRIBUTES + 1);
    let hostile = [
        ("<!DOCTYPE a [<!ENTITY e 'x'>]><a/>".to_string(), "document type"),
        (deep, "deep"),
        (format!("<a{attributes}/>"), "attributes"),
        (bindings, "binds"),
    ];
    for (text, what) in hostile {
        assert!(complaint(&text).contains(what), "{what}");
    }
    let endless = std::iter::repeat_n("x".repeat(1 << 16), MOST_TOKEN >> 15);
    for first in ["<a b='", "<a>", "<!--", "<a><![CDATA[", "<?x "] {
        let mut reader = Reader::new(Log::default());
        reader.feed(first.as_bytes()).unwrap();
        let mut pieces = endless.clone();
        let fault = pieces.find_map(|piece| reader.feed(piece.as_bytes()).err());
        assert!(fault.unwrap().to_string().contains("bytes"), "{first}");
        assert!(pieces.len() > MOST_TOKEN >> 17);
    }
}
